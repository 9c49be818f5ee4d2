/// Making, reading and breaking a world's joints.
#pragma once
#include "engine/world_state.h"

namespace engine {

Joint makeJoint(const WorldState& s, const JointDef& def);
JointState stateOf(const WorldState& s, const Joint& joint);
/// JointState::separation alone, m.
double separationOf(const WorldState& s, const Joint& joint);

/// At the end of a step. followJoints counts turns and finds torn joints; breakJoints removes joints loaded
/// beyond their strength, and returns true if there were any.
void followJoints(WorldState& s, double dt);
bool breakJoints(WorldState& s);

/// After the caller has moved a body: finds its position on paths again.
void findOnPaths(WorldState& s, int body);

/// Keeps bodies awake that a motor of nonzero speed acts on.
void wakeMotors(WorldState& s);
bool hasMotors(const WorldState& s);

}  // namespace engine
