/// From a world's joints to rows and trees.
#pragma once
#include "engine/solver/solver.h"

namespace engine {

/// One of its bodies is, and then both that move are.
inline bool isAsleep(const Joint& joint, const Bodies& bodies) {
    return bodies.isAsleep(joint.def.a.index) || bodies.isAsleep(joint.def.b.index);
}

/// A constraint, and what acts along its coordinates, for every joint that is awake; for when joints
/// come or go.
void collectJoints(std::span<const Joint> joints, const Bodies& bodies, const Settings& settings,
                   Solver& solver);

/// The factors of the trees, and rows of all joints outside them, at the bodies' present poses.
void prepareJoints(std::span<Joint> joints, const Bodies& bodies, const Settings& settings,
                   Solver& solver);

/// J, stored in a soft joint: k C^2 / 2 of its rows, with the stiffness that suits their masses;
/// and in the springs along its coordinates; with velocities of half a sub-step ago, as energyOf.
double elasticEnergy(const Joint& joint, const Bodies& bodies);

/// Joints' impulses go back to where the next step finds them; their mean forces over the step.
void storeImpulses(const Solver& solver, const Bodies& bodies, std::span<Joint> joints, double dt);

}  // namespace engine
