/// Finds the formulas in a text: $x$ within a line, $$x$$ on its own line. As in Pandoc, the first
/// $ has no space after it, the last none before it and no digit after it, so that "$5 and $6" are
/// prices. There are none in `code` and none across an empty line; \$ is a dollar.
#pragma once
#include <string>
#include <vector>

namespace demos {

struct TextFormula {
    std::string tex;
    bool display = false;
    std::size_t begin = 0, end = 0;  // bytes of the text, with the dollars
    std::size_t at = 0;              // where `tex` begins
};

/// The parts of a text that are not plain words, in order.
struct ScannedText {
    struct Span {
        std::size_t begin = 0, end = 0;  // bytes
    };
    std::vector<TextFormula> formulas;
    std::vector<Span> code;          // with its backquotes
    std::vector<std::size_t> loose;  // each $ that belongs to no formula, code or price
};
ScannedText scannedText(const std::string& text);

/// In the order of the text.
std::vector<TextFormula> formulasIn(const std::string& text);

/// Throws FormulaError with the byte of the text.
std::string mathMlIn(const TextFormula& formula);

}  // namespace demos
