"""embed_math_font.py FONT OUT: the part of an OpenType math font that formulas use, as C++ text.

The whole font is five times as large. Letters in bold, script and double-struck have their own code
points; size variants and pieces of brackets are included with the signs that they belong to.
A compiler need not accept literals above 64 KiB (C++ [implimits]): the text is split in pieces."""

import base64
import io
import sys

from fontTools import subset

RANGES = [
    (0x20, 0x7E), (0xA0, 0xA0), (0xAC, 0xAC), (0xB0, 0xB7), (0xD7, 0xD7), (0xF7, 0xF7),
    (0x2C6, 0x2C7), (0x2D8, 0x2DC), (0x300, 0x308), (0x338, 0x338), (0x391, 0x3D6), (0x3F1, 0x3F5),
    (0x2010, 0x2016), (0x2020, 0x2022), (0x2026, 0x2026), (0x2032, 0x2034), (0x2044, 0x2044),
    (0x2061, 0x2064), (0x20D7, 0x20D7), (0x210B, 0x2134), (0x2190, 0x2199), (0x21A6, 0x21A6),
    (0x21C0, 0x21C0), (0x21D0, 0x21D4), (0x2200, 0x22FF), (0x2308, 0x230B), (0x23B4, 0x23B5),
    (0x23DC, 0x23DF), (0x25A1, 0x25A1), (0x25B3, 0x25B3), (0x25CB, 0x25CB), (0x27E8, 0x27E9),
    (0x27F5, 0x27FA), (0x2A7D, 0x2A7E), (0x1D400, 0x1D467), (0x1D49C, 0x1D4CF),
    (0x1D538, 0x1D56B), (0x1D6A4, 0x1D71B),
]
PIECE = 8000  # letters


def base64_of(path):
    options = subset.Options()
    options.flavor = "woff2"
    options.layout_features = ["ssty", "dtls"]  # script variants; dotless letters under accents
    options.hinting = False
    font = subset.load_font(path, options)
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=[c for low, high in RANGES for c in range(low, high + 1)])
    subsetter.subset(font)
    out = io.BytesIO()
    subset.save_font(font, out, options)
    return base64.b64encode(out.getvalue()).decode("ascii")


def main():
    text = base64_of(sys.argv[1])
    pieces = "\n".join(f'        "{text[i:i + PIECE]}",' for i in range(0, len(text), PIECE))
    with open(sys.argv[2], "w", encoding="ascii") as file:
        file.write(f"""// Made by embed_math_font.py.
#include "demos/slides/math_font.h"

namespace demos {{
namespace {{

std::string joined() {{
    std::string text;
    for (const char* piece : {{
{pieces}
         }})
        text += piece;
    return text;
}}

}}  // namespace

const std::string& mathFont() {{
    static const std::string font = joined();
    return font;
}}

}}  // namespace demos
""")


main()
