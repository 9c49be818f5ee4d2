/// What is rarely intended at the start of a scene: bodies that overlap, bodies as light as air.
#pragma once
#include <string>
#include <vector>

#include "demos/play/stage.h"

namespace demos {

/// A line for each pair that overlaps by more than the slop before the first step, the deepest
/// first; for more than five pairs, five lines and one with the number of the others. Then one for
/// all bodies with a density below 10 kg/m^3, unless the scene has a medium as thin.
std::vector<std::string> warningsAtStart(const Stage& stage);

}  // namespace demos
