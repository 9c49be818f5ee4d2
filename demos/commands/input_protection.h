/// Nothing that is written may take the place of a scene file that is read.
#pragma once
#include <string>
#include <vector>

namespace demos {

/// Throws Stop (usage) where a target is one of the scenes. Empty targets are none.
void spareScenes(const std::vector<std::string>& scenes, const std::vector<std::string>& targets);

}  // namespace demos
