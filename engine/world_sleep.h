/// Who falls asleep and who wakes, from everything a world knows: contacts, joints, and what the
/// caller did. All of it happens between two steps.
#pragma once
#include "engine/world_state.h"

namespace engine {

/// To wake with the next step: the body's island, and those that it touches or is jointed to.
void callAround(WorldState& s, int body);

/// To stay awake: whoever a force acts on within the next dt (s).
void callForced(WorldState& s, double dt);

/// Whoever was called, with its contacts and joints.
void wakeCalled(WorldState& s);

/// With the contacts that the next step is to solve: who touches somebody awake wakes; islands that
/// have been slow for long enough fall asleep.
void updateSleep(WorldState& s, double dt);

}  // namespace engine
