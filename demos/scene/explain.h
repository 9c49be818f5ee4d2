/// What the keys of a scene file mean: the text of `impulse list --explain`.
#pragma once
#include <string>
#include <vector>

namespace demos {

/// The sentence on a key, its type, unit, default and range, and the keys of the table that it
/// holds. `path`: "solver.baumgarte"; a list may be followed by the name or number of an item, as
/// for --set: "body.ball.mass"; "scene": all tables. Throws Stop (usage) with the nearest right
/// keys.
std::string explanationOf(const std::string& path);

/// What explanationOf says of one key.
struct KeyFacts {
    std::string path;  // "solver.sweeps"; "values.NAME" where any name is a key
    std::string sentence, type, unit, usual, range;  // empty: none
};

/// Every key once, by its shortest path, those of a table together.
std::vector<KeyFacts> keyFacts();

}  // namespace demos
