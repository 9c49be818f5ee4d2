// The only file that includes stb_truetype.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "render/blend.h"
#include "render/canvas.h"
#include "render/font.h"
#include "render/overlay.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

namespace render {
namespace {

struct Glyph {
    int width = 0, height = 0, left = 0, top = 0;  // pixels, from the pen to the bitmap's corner
    float advance = 0.0f;                          // pixels
    std::vector<unsigned char> cover;
};

class Font {
public:
    Font() { stbtt_InitFont(&info_, fontBytes(), 0); }

    const Glyph& glyph(int codepoint, int pixels) {
        Glyph& g = glyphs_[{codepoint, pixels}];
        if (g.advance > 0.0f) return g;
        const float scale = stbtt_ScaleForPixelHeight(&info_, static_cast<float>(pixels));
        int advance = 0, bearing = 0;
        stbtt_GetCodepointHMetrics(&info_, codepoint, &advance, &bearing);
        g.advance = std::max(static_cast<float>(advance) * scale, 0.01f);
        unsigned char* bitmap = stbtt_GetCodepointBitmap(&info_, scale, scale, codepoint, &g.width,
                                                         &g.height, &g.left, &g.top);
        g.cover.assign(bitmap, bitmap + g.width * g.height);
        stbtt_FreeBitmap(bitmap, nullptr);
        return g;
    }
    float ascent(int pixels) const {
        int ascent = 0, descent = 0, gap = 0;
        stbtt_GetFontVMetrics(&info_, &ascent, &descent, &gap);
        return static_cast<float>(ascent) *
               stbtt_ScaleForPixelHeight(&info_, static_cast<float>(pixels));
    }

private:
    stbtt_fontinfo info_;
    std::map<std::pair<int, int>, Glyph> glyphs_;
};

Font& font() {
    static Font theFont;
    return theFont;
}

/// The code points of UTF-8; a broken byte becomes a question mark.
std::vector<int> codepoints(const std::string& text) {
    std::vector<int> result;
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i++]);
        const int more = first < 0x80 ? 0 : first >> 5 == 6 ? 1 : first >> 4 == 14 ? 2 : first >> 3 == 30 ? 3 : -1;
        int code = more <= 0 ? first : first & (0x3f >> more);
        bool whole = more >= 0;
        for (int k = 0; k < more && whole; ++k) {
            whole = i < text.size() && (static_cast<unsigned char>(text[i]) >> 6) == 2;
            if (whole) code = code << 6 | (static_cast<unsigned char>(text[i++]) & 0x3f);
        }
        result.push_back(whole && code >= 32 ? code : '?');
    }
    return result;
}

/// Calls draw(glyph, x, y) with the top left corner of every glyph of a line.
template <class Draw>
float walk(const std::string& text, int pixels, float x, float baseline, Draw draw) {
    for (const int code : codepoints(text)) {
        const Glyph& g = font().glyph(code, pixels);
        draw(g, static_cast<int>(std::lround(x)) + g.left, static_cast<int>(std::lround(baseline)) + g.top);
        x += g.advance;
    }
    return x;
}

void paint(Image& image, const Glyph& g, int left, int top, const Color& color, float strength) {
    for (int y = 0; y < g.height; ++y)
        for (int x = 0; x < g.width; ++x) {
            const int px = left + x, py = top + y;
            if (px < 0 || py < 0 || px >= image.width || py >= image.height) continue;
            const float cover = static_cast<float>(g.cover[y * g.width + x]) / 255.0f;
            blend(image.at(px, py), color, cover * strength);
        }
}

/// Light behind dark letters, dark behind light ones.
Color haloOf(const Color& color) {
    const bool dark = color.r + color.g + color.b < 1.5f;
    return dark ? Color{1, 1, 1, 1} : Color{0.05f, 0.05f, 0.06f, 1};
}

int pixelsOf(const Text& text, const Image& image) {
    const float scaled = text.size * static_cast<float>(image.height) / 720.0f;
    return std::max(static_cast<int>(std::lround(scaled)), 9);  // smaller is not legible
}

void drawLine(Image& image, const Text& text, int pixels, float x, float baseline) {
    const int reach = std::max(pixels / 14, 1);
    const Color halo = haloOf(text.color);
    walk(text.text, pixels, x, baseline, [&](const Glyph& g, int left, int top) {
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx)
                if (dx != 0 || dy != 0) paint(image, g, left + dx, top + dy, halo, 0.16f);
    });
    walk(text.text, pixels, x, baseline, [&](const Glyph& g, int left, int top) {
        paint(image, g, left, top, text.color, 1.0f);
    });
}

}  // namespace

float textWidth(const std::string& text, float pixels) {
    return walk(text, static_cast<int>(std::lround(pixels)), 0, 0, [](const Glyph&, int, int) {});
}

void drawLabel(Image& image, const std::string& text, Point at, Anchor anchor, float pixels,
               const Color& color) {
    const float most = 4.0f * static_cast<float>(image.width + image.height);
    if (!(std::abs(at.x) <= most && std::abs(at.y) <= most && pixels >= 1.0f && pixels <= most))
        return;  // not finite, or nowhere near the picture
    const float width = anchor == Anchor::start ? 0.0f : textWidth(text, pixels);
    const float x = at.x - (anchor == Anchor::end ? width : 0.5f * width);
    walk(text, static_cast<int>(std::lround(pixels)), x, at.y,
         [&](const Glyph& g, int left, int top) { paint(image, g, left, top, color, 1.0f); });
}

void drawTexts(Image& image, const Frame& frame) {
    const float margin = 0.033f * static_cast<float>(image.height);
    float used[4] = {margin, margin, margin, margin};  // from the picture's edge, by corner
    for (const Corner corner :
         {Corner::topLeft, Corner::topRight, Corner::bottomLeft, Corner::bottomRight}) {
        const bool bottom = corner == Corner::bottomLeft || corner == Corner::bottomRight;
        std::vector<const Text*> lines;
        for (const Text& text : frame.texts)
            if (text.corner == corner && !text.text.empty()) lines.push_back(&text);
        if (bottom) std::reverse(lines.begin(), lines.end());
        for (const Text* text : lines) {
            const int pixels = pixelsOf(*text, image);
            const float height = 1.3f * static_cast<float>(pixels);
            float& edge = used[static_cast<int>(corner)];
            const float top = bottom ? static_cast<float>(image.height) - edge - static_cast<float>(pixels)
                                     : edge;
            const bool right = corner == Corner::topRight || corner == Corner::bottomRight;
            const float x = right ? static_cast<float>(image.width) - margin -
                                        textWidth(text->text, static_cast<float>(pixels))
                                  : margin;
            drawLine(image, *text, pixels, x, top + font().ascent(pixels));
            edge += height;
        }
    }
}

}  // namespace render
