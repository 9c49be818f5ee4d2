/// Words of a slide as paragraphs of DrawingML (ECMA-376, part 1, 21.1.2): text that can be edited.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace demos {

struct PptxLook {
    double size = 27.0, line = 38.0;  // px of a slide of 1280x720
    bool bold = false;
    const char* color = "tx1";  // of the theme
    const char* align = "l";    // l, ctr or r
};

/// The relationship of a link's address.
using PptxLink = std::function<std::string(const std::string& address)>;

/// A paragraph that is not yet placed.
struct PptxParagraph {
    std::string runs;
    double before = 0.0, indent = 0.0;  // of the size: space above it, on its left
    std::string bullet;                 // "": none
};

/// The paragraphs of each top-level block of CommonMark, as in htmlOf(). Formulas become ordinary
/// letters. Throws FormulaError.
std::vector<std::vector<PptxParagraph>> pptxBlocks(const std::string& commonMark,
                                                   const PptxLook& look, const PptxLink& link);
/// One paragraph.
PptxParagraph pptxLine(const std::string& commonMark, const PptxLook& look, const PptxLink& link);
PptxParagraph pptxPlainLine(const std::string& text, const PptxLook& look);
/// A paragraph per line of code.
std::vector<PptxParagraph> pptxCode(const std::string& code, const PptxLook& look);

/// <a:p> elements, the first without space above it.
std::string pptxParagraphs(const std::vector<PptxParagraph>& paragraphs, const PptxLook& look);

/// Escaped, without the characters that XML does not allow.
std::string xmlText(const std::string& text);

}  // namespace demos
