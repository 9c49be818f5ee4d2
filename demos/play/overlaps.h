/// Bodies that overlap at the start: they are pushed apart, which is rarely what a scene intends.
#pragma once
#include <string>
#include <vector>

#include "demos/play/stage.h"

namespace demos {

/// A line for each pair that overlaps by more than the slop before the first step, the deepest
/// first; for more than five pairs, five lines and one with the number of the others.
std::vector<std::string> overlapsAtStart(const Stage& stage);

}  // namespace demos
