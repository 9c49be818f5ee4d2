/// From samples to what a line of pixels can show, and labels that do not overlap.
#pragma once
#include <string>
#include <vector>

#include "render/canvas.h"

namespace demos {

/// At most two points for every column of pixels, its lowest and its highest, in their order.
std::vector<render::Point> thinned(const std::vector<render::Point>& points);

/// Where labels go that want to be at `wanted` and need `spacing` to each other, within low..high:
/// the least sum of squared shifts. Labels that want the same keep their order. In the order given;
/// there must be room for all.
std::vector<float> separated(const std::vector<float>& wanted, float spacing, float low,
                             float high);

/// The text, or as much of it as has room, with an ellipsis.
std::string fitted(const std::string& text, float pixels, float room);

/// The same, with the ellipsis in the middle: what tells names apart is often at their ends.
std::string fittedName(const std::string& text, float pixels, float room);

/// Without what comes after its last commas and brackets, as far as it takes; may still be wider.
std::string withoutAsides(const std::string& text, float pixels, float room);

}  // namespace demos
