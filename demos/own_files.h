/// Nothing that is written may take the place of a scene file that is read.
#pragma once
#include "demos/options.h"

namespace demos {

/// Throws Stop (usage) where a target is one of the scenes.
void spareScenes(const Options& options);

}  // namespace demos
