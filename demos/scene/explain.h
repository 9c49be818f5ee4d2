/// What the keys of a scene file mean: the text of `impulse list --explain`.
#pragma once
#include <string>

namespace demos {

/// The sentence on a key, its type, unit, default and range, and the keys of the table that it
/// holds. `path`: "solver.baumgarte"; a list may be followed by the name or number of an item, as
/// for --set: "body.ball.mass"; "scene": all tables. Throws Stop (usage) with the nearest right
/// keys.
std::string explanationOf(const std::string& path);

}  // namespace demos
