/// Thins out samples for a line of pixels, and places labels without overlap.
#pragma once
#include <string>
#include <vector>

#include "render/canvas.h"

namespace demos {

/// At most two points for every column of pixels, the lowest and the highest, in their order.
std::vector<render::Point> thinned(const std::vector<render::Point>& points);

/// Moves labels from their `wanted` positions so that they are `spacing` apart and within
/// low..high, with the least sum of squared shifts. Labels with equal positions keep their order.
/// The result is in the order given. There must be room for all.
std::vector<float> separated(const std::vector<float>& wanted, float spacing, float low,
                             float high);

/// The text, or as much of it as fits, with an ellipsis.
std::string fitted(const std::string& text, float pixels, float room);

/// The same with the ellipsis in the middle: names often differ at their ends.
std::string fittedName(const std::string& text, float pixels, float room);

/// Cuts the text at its last commas and brackets until it fits; it may still be wider.
std::string withoutAsides(const std::string& text, float pixels, float room);

}  // namespace demos
