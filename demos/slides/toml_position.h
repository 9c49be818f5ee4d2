/// The places of bytes of strings in TOML files, for complaints about these strings.
#pragma once
#include <cstddef>
#include <string_view>

#include "demos/scene/description.h"

namespace demos {

/// Where a string is written.
struct TomlPosition {
    Place place;                   // of its opening quotes
    std::string_view source = {};  // the file; empty if it is not available
};

/// The place of a byte of the string, as an editor counts: it considers escapes, skipped line ends
/// and the newline after opening quotes. Without a source, as after --set, the place of the string.
Place placeIn(const TomlPosition& position, std::size_t byte);

/// Whether a byte of the string is an escape in the file: the newline of "\n", the tab of "\theta".
bool isEscape(const TomlPosition& position, std::size_t byte);

}  // namespace demos
