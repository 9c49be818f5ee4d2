/// The fonts of pictures, embedded at build time.
#pragma once

namespace render {

/// Inter, made for screens.
const unsigned char* screenFontBytes();

/// Its italic, for the variables of formulas.
const unsigned char* italicFontBytes();

/// DejaVu Sans, for characters that Inter lacks: most of the mathematical signs.
const unsigned char* fallbackFontBytes();

}  // namespace render
