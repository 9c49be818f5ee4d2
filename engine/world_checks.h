/// What callers of a World must keep to. Breaking it is a bug of theirs, which stops the program with
/// advice (base/check.h); what can only be seen later is in the step's report.
#pragma once
#include "engine/world_state.h"

namespace engine {

inline constexpr int kMostSubsteps = 10'000;
inline constexpr int kMostSweeps = 1'000'000;  // of a sub-step; also of its nudges
inline constexpr int kMostThreads = 256;

/// Nothing changes a world while it calls its force field or observer.
void checkIdle(const WorldState& s);
void checkSettings(const Settings& settings);
void checkPose(const Pose& pose);
void checkBody(const BodyDef& def);
void checkJoint(const WorldState& s, const JointDef& def);
void checkFreedom(JointType type, int coordinate, const Freedom& freedom);
void checkForce(const ForceDef& def);

}  // namespace engine
