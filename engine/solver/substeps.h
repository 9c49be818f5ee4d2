/// How many sub-steps an island asks for: bodies that contacts and joints hold together.
///   links under tension     omega = sqrt(F r / I) is the rate at which a link pulled with F at the arm
///                           r swings across the pull; the feedback of joint nudges is stable and
///                           keeps its energy while h omega < 1 (1000 kg swung on 1 kg links: joints
///                           come apart by 0.2 mm; at 1.2 by 2 mm, at 1.4 by 30 mm, and energy comes
///                           from nowhere)
///   fast joints             h |w| < 0.1: the arms' turning in a sub-step stays nearly linear
///   columns and walls       the taller, the more (columns.h)
///   heavy on light          eight, where one body of a contact weighs ten times the other; and where it is a
///                           hundred times, 3.2 for every level of the column (1000:1 on four: 16)
/// The number is 4, 8, 12, 16, 24 or 32 (with 4 `substeps`), never above `maxSubsteps`. It goes up at
/// once and down only after a second that fewer would have done for; with joints after ten, because a
/// symplectic integrator keeps its energy only while its step stays the same (five links lose 10 % in
/// two minutes with one second, 0.4 % with ten).
#pragma once
#include "engine/solver/columns.h"
#include "engine/solver/solver.h"

namespace engine {

class Substeps {
public:
    /// For every body that is awake the number of its island, in a step of dt (s). `islands`: the bodies
    /// that hang together. Returns the largest.
    int choose(DisjointSets& islands, std::span<const Contact> contacts,
               std::span<const Joint> joints, const Bodies& bodies, const Solver& solver,
               const Settings& settings, double dt);
    int of(int body) const { return chosen_[body].current; }

private:
    struct Chosen {
        int current = 0;     // 0: not chosen yet
        int enough = 0;      // that would have done,
        double calm = 0.0;   // s, for this long
    };
    struct Island {
        Chosen chosen;
        double needed = 0.0;
        bool jointed = false, any = false;
    };

    void addJoints(DisjointSets& islands, std::span<const Joint> joints, const Bodies& bodies,
                   const Solver& solver, double dt);
    void addContacts(DisjointSets& islands, std::span<const Contact> contacts,
                     const Bodies& bodies, const Solver& solver);

    Columns columns_;
    std::vector<Chosen> chosen_;   // by body
    std::vector<Island> islands_;  // by leader
};

/// The forces that trees whose joints came or went would carry in the coming step, to first order:
/// what the next choice goes by.
void estimateTension(std::span<Joint> joints, const Bodies& bodies, const Vec3& gravity,
                     Solver& solver, double dt);

}  // namespace engine
