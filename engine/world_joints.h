/// A world's joints: made, looked at, broken.
#pragma once
#include "engine/world_state.h"

namespace engine {

/// The caller's bugs (base/check.h).
void checkJoint(const WorldState& s, const JointDef& def);
void checkFreedom(JointType type, int coordinate, const Freedom& freedom);

Joint makeJoint(const WorldState& s, const JointDef& def);
JointState stateOf(const WorldState& s, const Joint& joint);
/// m; JointState::separation alone.
double separationOf(const WorldState& s, const Joint& joint);

/// At the end of a step: turns are counted, what is torn is found, and joints that carried more than
/// they can bear go. True: some have.
void followJoints(WorldState& s);
bool breakJoints(WorldState& s);

/// The caller has put a body elsewhere: its place on a path is looked for again.
void findOnPaths(WorldState& s, int body);

/// A motor that wants to turn something keeps it awake.
void wakeMotors(WorldState& s);
bool hasMotors(const WorldState& s);

}  // namespace engine
