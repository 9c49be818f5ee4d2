// For builds without a font to embed: the page uses the reader's own mathematical font, if any.
#include "demos/slides/math_font.h"

#ifndef IMPULSE_HAVE_MATH_FONT
namespace demos {

const std::string& mathFont() {
    static const std::string none;
    return none;
}

}  // namespace demos
#endif
