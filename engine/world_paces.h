/// A step's sub-steps: how many, and whose turn each of them is (solver/paces.h).
#pragma once
#include "engine/world_state.h"

namespace engine {

/// As many as the islands and the looks for contacts ask for, in a step of dt (s). An impulse is a force
/// times a sub-step: where that gets another length, what is carried over follows.
void choosePaces(WorldState& s, double dt);

/// Islands that have met within a step go on together.
void joinPaces(WorldState& s, double dt);

/// Whose turn sub-step i is.
void beginSubstep(WorldState& s, int i);

}  // namespace engine
