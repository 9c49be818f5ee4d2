/// Simulates a scene to its end. The results so far are kept if the run ends early.
#pragma once
#include <functional>

#include "demos/options/options.h"
#include "demos/snapshot/player.h"

namespace demos {

/// The number of steps in the scene's length, at least one.
long stepsOf(const SceneDescription& scene);

/// Calls `look(step)` at time 0 and after every step. If the run diverges or is interrupted, calls
/// `keep()` to write the results so far, and throws Stop.
void playThrough(Player& player, const Options& options, const std::function<void(long)>& look,
                 const std::function<void()>& keep);

}  // namespace demos
