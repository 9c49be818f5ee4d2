/// The number of sub-steps of a step, and which bodies act in each (solver/paces.h).
#pragma once
#include "engine/world_state.h"

namespace engine {

/// Chooses as many sub-steps as the islands and contact detection need, for a step of dt (s). An impulse is a
/// force times a sub-step, so impulses carried over are scaled when its length changes.
void choosePaces(WorldState& s, double dt);

/// Combines islands that have met before sub-step i.
void joinPaces(WorldState& s, int i, double dt);

/// Selects the bodies that act in sub-step i.
void beginSubstep(WorldState& s, int i);

}  // namespace engine
