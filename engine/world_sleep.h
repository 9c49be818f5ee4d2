/// Decides which bodies fall asleep and which wake, from contacts, joints, and the caller's
/// changes. This happens only between two steps.
#pragma once
#include "engine/world_state.h"

namespace engine {

/// Calls the body's island, and those it touches or is joined to, to wake in the next step.
void callAround(WorldState& s, int body);

/// Calls the bodies that a force acts on within the next dt (s) to stay awake.
void callForced(WorldState& s, double dt);

/// Wakes the called islands, with their contacts and joints.
void wakeCalled(WorldState& s);

/// With the contacts of the next step: wakes islands touched by awake bodies, and puts islands to
/// sleep that have been slow for long enough.
void updateSleep(WorldState& s, double dt);

}  // namespace engine
