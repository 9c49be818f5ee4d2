/// Texts of TOML files with the places of their bytes: for complaints of what stands in them.
#pragma once
#include <cstddef>
#include <string_view>

#include "demos/scene/description.h"

namespace demos {

/// Where a text is written.
struct TomlPosition {
    Place place;                   // of its opening quotes
    std::string_view source = {};  // the file; empty where it is not at hand
};

/// The place of the text's byte, as an editor counts: escapes, left-out line ends and the newline
/// after opening quotes are considered. That of the quotes where there are none, as after --set.
Place placeIn(const TomlPosition& written, std::size_t byte);

/// Whether the text's byte is an escape in the file: the newline of "\n", the tab of "\theta".
bool isEscape(const TomlPosition& written, std::size_t byte);

}  // namespace demos
