/// Tells one build of the program from another.
#pragma once
#include <string>

#include "demos/text/text_hash.h"

namespace demos {

/// The program's own bytes: another build may draw or simulate differently.
void addProgram(TextHash& hash);

/// Its version and a hash of its bytes: "0.1.0 0123456789abcdef".
std::string programName();

}  // namespace demos
