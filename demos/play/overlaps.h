/// Bodies that begin inside each other: they are pressed apart, which is seldom what a scene meant.
#pragma once
#include <string>
#include <vector>

#include "demos/play/stage.h"

namespace demos {

/// A line for each pair that overlaps by more than the slop before the first step, the deepest first;
/// of more than five pairs, five lines and one with the number of the others.
std::vector<std::string> overlapsAtStart(const Stage& stage);

}  // namespace demos
