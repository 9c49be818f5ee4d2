/// What is wrong with a slide's words, told before anything is played: formulas that KaTeX refuses,
/// numbers that the slide's runs do not have, bytes that no page takes.
#pragma once
#include <string>
#include <vector>

#include "demos/slides/toml_position.h"
#include "demos/text/complaints.h"

namespace demos {

constexpr std::size_t kMostWords = 16u << 10;  // bytes of a text

/// CommonMark. `runs`: whose numbers may be named, in their order.
void checkWords(const std::string& words, const TomlPosition& written,
                const std::vector<SceneDescription>& runs, Complaints& complaints);

/// LaTeX, which may hold numbers as well.
void checkFormula(const std::string& tex, const TomlPosition& written,
                  const std::vector<SceneDescription>& runs, Complaints& complaints);

/// That there is no line break in it.
void checkLine(const std::string& text, const TomlPosition& written, Complaints& complaints);

/// As it is, without formulas and numbers.
void checkPlain(const std::string& text, const TomlPosition& written, Complaints& complaints);

}  // namespace demos
