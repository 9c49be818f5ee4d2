/// Names of files where an address belongs.
#pragma once
#include <string>

namespace demos {

/// Everything but plain characters as %20.
std::string escapedPath(const std::string& path);

}  // namespace demos
