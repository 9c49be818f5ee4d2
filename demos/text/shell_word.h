/// Words of a command line, quoted for a shell.
#pragma once
#include <string>

namespace demos {

/// In single quotes if a shell would split or expand the word.
std::string shellWord(const std::string& word);

/// Whether a shell would take the text as words alone, as shellWord() writes them, and run no
/// second program.
bool arePlainWords(const std::string& text);

}  // namespace demos
