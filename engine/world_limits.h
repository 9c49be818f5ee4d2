/// Bodies that cannot go on, so that the rest of the world can: those whose pose or velocity is not finite are
/// removed, those beyond 1e4 m/s or rad/s slowed down, those beyond 1e5 m removed. All are reported.
#pragma once
#include "engine/world_state.h"

namespace engine {

/// Slows down bodies that are too fast: through a force or the caller, before they move and pull others along;
/// and at the end of a step.
void limitSpeeds(WorldState& s);

/// Reports the bodies that were slowed down in this step.
void reportTooFast(WorldState& s);

/// Removes and reports bodies that are too far away.
void removeTheFar(WorldState& s);

/// False: the pose or velocity of some body is not finite. Then the step is undone and the bodies that caused
/// it are removed, or, if the cause is unknown, all affected bodies.
bool staysFinite(WorldState& s);

}  // namespace engine
