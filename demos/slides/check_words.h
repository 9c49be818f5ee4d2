/// Checks a slide's words before anything is simulated: formulas that KaTeX refuses, numbers that
/// the slide's runs do not have, bytes that a page cannot contain.
#pragma once
#include <string>
#include <vector>

#include "demos/slides/toml_position.h"
#include "demos/text/complaints.h"

namespace demos {

constexpr std::size_t kMostWords = 16u << 10;  // bytes of a text

/// Checks CommonMark. `runs`: in order, those whose numbers the words may name.
void checkWords(const std::string& words, const TomlPosition& position,
                const std::vector<SceneDescription>& runs, Complaints& complaints);

/// Checks LaTeX, which may contain numbers.
void checkFormula(const std::string& tex, const TomlPosition& position,
                  const std::vector<SceneDescription>& runs, Complaints& complaints);

/// Checks that the text is one line.
void checkLine(const std::string& text, const TomlPosition& position, Complaints& complaints);

/// Checks a text without formulas and numbers.
void checkPlain(const std::string& text, const TomlPosition& position, Complaints& complaints);

}  // namespace demos
