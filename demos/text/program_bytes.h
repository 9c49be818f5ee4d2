/// Tells one build of the program from another.
#pragma once
#include <cstdint>
#include <string>

namespace demos {

/// A hash of the program's own bytes: another build may draw or simulate differently.
std::uint64_t programHash();

/// Its version and this hash: "0.1.0 0123456789abcdef".
std::string programName();

}  // namespace demos
