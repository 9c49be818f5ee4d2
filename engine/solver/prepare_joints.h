/// Makes rows and trees from a world's joints.
#pragma once
#include "engine/solver/solver.h"

namespace engine {

/// True if one of its bodies is asleep; then all its movable bodies are.
inline bool isAsleep(const Joint& joint, const Bodies& bodies) {
    return bodies.isAsleep(joint.def.a.index) || bodies.isAsleep(joint.def.b.index);
}

/// Makes a constraint, and drives along its coordinates, for every joint that is awake. Called when joints
/// are added or removed.
void collectJoints(std::span<Joint> joints, const Bodies& bodies, const Settings& settings,
                   Solver& solver);

/// Computes the factors of a group's trees, and the rows of its joints outside them, at the present poses.
void prepareJoints(std::span<Joint> joints, const Bodies& bodies, const Settings& settings, int group,
                   Solver& solver);

/// Sorts trees, joints outside them and drives into the groups of their islands; initially, and if islands are not
/// solved one by one, all are in group 0.
void groupJoints(const Bodies& bodies, Solver& solver);

/// Before a sub-step is solved: which joints act in it.
void chooseActingJoints(const Bodies& bodies, Solver& solver);

/// The energy stored in a soft joint, J: k C^2 / 2 of its rows, with the stiffness for their masses, plus
/// that of the springs along its coordinates; at the time of the velocities, half a sub-step ago, like
/// energyOf.
double elasticEnergy(const Joint& joint, const Bodies& bodies);

/// Stores the joints' impulses for the next step, and their mean forces over the step.
void storeImpulses(const Solver& solver, const Bodies& bodies, std::span<Joint> joints, double dt);

}  // namespace engine
