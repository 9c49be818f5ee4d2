/// Words of a command line as a shell takes them.
#pragma once
#include <string>

namespace demos {

/// In single quotes where a shell would take the word apart.
std::string shellWord(const std::string& word);

}  // namespace demos
