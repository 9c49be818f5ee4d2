/// A whole run, whose results are worth keeping however it ends.
#pragma once
#include <functional>

#include "demos/options/options.h"
#include "demos/snapshot/player.h"

namespace demos {

/// Of a scene's length, one at least.
long stepsOf(const SceneDescription& scene);

/// Calls `look(step)` at time 0 and after every step. Throws Stop where the run diverges or is
/// interrupted, after `keep()`: what was good stays readable.
void playThrough(Player& player, const Options& options, const std::function<void(long)>& look,
                 const std::function<void()>& keep);

}  // namespace demos
