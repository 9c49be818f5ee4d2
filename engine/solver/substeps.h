/// Into how many sub-steps the next step has to be cut.
///   links under tension     omega = sqrt(F r / I) is the rate at which a link pulled with F at the arm
///                           r swings across the pull; the feedback of joint nudges is stable and
///                           keeps its energy while h omega < 0.8 (1000 kg on 1 kg links: 850 rad/s,
///                           four sub-steps blow up, sixteen keep the energy to 0.06 %)
///   fast joints             h |w| < 0.1: the arms' turning in a sub-step stays nearly linear
///   heavy on light          eight, where one body of a contact weighs ten times the other
/// The number is a power of two times `substeps`, never above `maxSubsteps`. It goes up at once and
/// down only after a second in which half would have done: a symplectic integrator keeps its energy
/// only while its step stays the same.
#pragma once
#include "engine/solver/prepare.h"

namespace engine {

struct SubstepChooser {
    int current = 0;     // 0: not chosen yet
    double calm = 0.0;   // s, for how long half would have done
};

int chooseSubsteps(SubstepChooser& chooser, std::span<const Contact> contacts,
                   std::span<const Joint> joints, const Bodies& bodies, const Solver& solver,
                   const Settings& settings, double dt);

}  // namespace engine
