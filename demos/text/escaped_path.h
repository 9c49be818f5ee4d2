/// File names in URLs.
#pragma once
#include <string>

namespace demos {

/// All characters except plain ones are written like %20.
std::string escapedPath(const std::string& path);

}  // namespace demos
