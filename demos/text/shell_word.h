/// Words of a command line, quoted for a shell.
#pragma once
#include <string>

namespace demos {

/// In single quotes if a shell would split or expand the word.
std::string shellWord(const std::string& word);

}  // namespace demos
