/// The impulses that joints outside the trees keep from the last sub-step are a guess. After a blow it may be a
/// bad one, because their rows turn with the bodies: what stopped a limb throws it back a sub-step later, with
/// energy that a few sweeps do not take away again. How good a guess is shows in the energy
///   f(s) = s c + s^2 w / 2,   c = lambda . (J v + b),   w = lambda . (J dv + gamma lambda)
/// that its share s brings, where v are the velocities that the trees allow without it, and dv what it changes
/// in them once the trees are solved again. f is least at s = -c / w. A guess that brings more than a quarter
/// of the kinetic energy E of the joined bodies, f(1) > E / 4, is reduced to this share.
///
/// Only groups are checked in which a body turns by more than 0.02 rad in the sub-step. Limits and motors keep
/// all: what seems bad there is the memory of a structure that trembles. An arm held out by eight limits would
/// sink.
#pragma once
#include "engine/dynamics/bodies.h"
#include "engine/solver/constraints.h"

namespace engine {

class KeptImpulses {
public:
    /// Before a solve: stores the kinetic energies of the groups that have such joints. A body counts once for
    /// each of its joints.
    void measure(const Bodies& bodies, int groups, const Constraints& c);
    /// Reduces bad guesses. All impulses have been applied, and no sweep was done yet.
    void check(Constraints& c, JointTrees& trees, std::span<Velocity> v) const;

private:
    std::vector<double> energies_;  // J, by group
};

}  // namespace engine
