// The only file that includes stb_truetype.
#include "render/glyphs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "render/blend.h"
#include "render/canvas.h"
#include "render/font.h"

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

std::vector<int> codepoints(const std::string& text) {
    std::vector<int> result;
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i++]);
        const int more = first < 0x80       ? 0
                         : first >> 5 == 6  ? 1
                         : first >> 4 == 14 ? 2
                         : first >> 3 == 30 ? 3
                                            : -1;
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

namespace {

constexpr float kAscentShare = 1901.0f / 2384.0f;  // of a line's height, for every font

struct Bitmap {
    int width = 0, height = 0;
    int left = 0, top = 0;  // pixels, from the pen to the upper left corner
    std::vector<unsigned char> cover;
};

struct Glyph {
    float advance = 0.0f;  // pixels
    Bitmap ink, halo;
};

/// The ink blended over itself at every shift up to `reach`, at a third of its strength each:
/// 1 - product of (1 - 0.3 cover).
Bitmap haloOf(const Bitmap& ink, int reach) {
    Bitmap halo{
        ink.width + 2 * reach, ink.height + 2 * reach, ink.left - reach, ink.top - reach, {}};
    if (ink.width == 0 || ink.height == 0) return {};
    for (int y = 0; y < halo.height; ++y)
        for (int x = 0; x < halo.width; ++x) {
            float open = 1.0f;
            for (int v = std::max(y - 2 * reach, 0); v <= std::min(y, ink.height - 1); ++v)
                for (int u = std::max(x - 2 * reach, 0); u <= std::min(x, ink.width - 1); ++u)
                    open *=
                        1.0f - 0.3f / 255.0f * static_cast<float>(ink.cover[v * ink.width + u]);
            halo.cover.push_back(static_cast<unsigned char>(255.0f * (1.0f - open) + 0.5f));
        }
    return halo;
}

/// One font file.
class Face {
public:
    explicit Face(const unsigned char* bytes) { stbtt_InitFont(&info_, bytes, 0); }

    bool has(int codepoint) const { return stbtt_FindGlyphIndex(&info_, codepoint) != 0; }
    float scale(float pixels) const {
        return stbtt_ScaleForMappingEmToPixels(&info_, static_cast<float>(kEmShare) * pixels);
    }
    int advance(int codepoint) const {
        int advance = 0, bearing = 0;
        stbtt_GetCodepointHMetrics(&info_, codepoint, &advance, &bearing);
        return advance;
    }
    LetterExtent extent(int codepoint) const {
        const float em = stbtt_ScaleForMappingEmToPixels(&info_, 1.0f);
        int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // all 0: it has no ink
        stbtt_GetCodepointBox(&info_, codepoint, &x0, &y0, &x1, &y1);
        const auto inEm = [&](int units) { return em * static_cast<float>(units); };
        return {inEm(advance(codepoint)), inEm(x0), inEm(x1), inEm(y0), inEm(y1)};
    }
    /// `stretch`: times as tall as the letter is.
    Bitmap bitmap(int codepoint, float scale, float shift, float stretch = 1.0f) const {
        Bitmap ink;
        unsigned char* bytes =
            stbtt_GetCodepointBitmapSubpixel(&info_, scale, stretch * scale, shift, 0.0f, codepoint,
                                             &ink.width, &ink.height, &ink.left, &ink.top);
        ink.cover.assign(bytes, bytes + ink.width * ink.height);
        stbtt_FreeBitmap(bytes, nullptr);
        return ink;
    }

private:
    stbtt_fontinfo info_;
};

bool isDigit(int codepoint) { return codepoint >= '0' && codepoint <= '9'; }

class Font {
public:
    Font() {
        for (int digit = '0'; digit <= '9'; ++digit)
            widestDigit_ = std::max(widestDigit_, screen_.advance(digit));
    }

    const Glyph& glyph(int codepoint, int pixels, Figures figures) {
        const bool wide = figures == Figures::tabular && isDigit(codepoint);
        Glyph& g = glyphs_[{codepoint, pixels, wide}];
        if (g.advance > 0.0f) return g;
        const Face& face = faceOf(codepoint, false);
        const float scale = face.scale(static_cast<float>(pixels));
        const int own = face.advance(codepoint), all = wide ? widestDigit_ : own;
        g.advance = std::max(static_cast<float>(all) * scale, 0.01f);
        const float aside = 0.5f * static_cast<float>(all - own) * scale;
        g.ink = face.bitmap(codepoint, scale, aside - std::floor(aside));
        g.ink.left += static_cast<int>(std::floor(aside));
        return g;
    }
    bool has(int codepoint) const { return screen_.has(codepoint) || fallback_.has(codepoint); }
    const Face& faceOf(int codepoint, bool italic) const {
        if (italic && italic_.has(codepoint)) return italic_;
        return screen_.has(codepoint) ? screen_ : fallback_;
    }
    const Bitmap& halo(int codepoint, int pixels) {
        Glyph& g = glyphs_[{codepoint, pixels, false}];
        if (g.halo.cover.empty()) g.halo = haloOf(g.ink, std::max(pixels / 7, 2));
        return g.halo;
    }

private:
    Face screen_{screenFontBytes()}, italic_{italicFontBytes()}, fallback_{fallbackFontBytes()};
    int widestDigit_ = 0;
    std::map<std::tuple<int, int, bool>, Glyph> glyphs_;  // by code, pixels, tabular
};

Font& font() {
    static Font theFont;
    return theFont;
}

/// Calls draw(code, glyph, x) for every glyph of a line, and returns the x of the line's end.
template <class Draw>
float walk(const std::string& text, int pixels, float x, Figures figures, Draw draw) {
    for (const int code : codepoints(text)) {
        const Glyph& g = font().glyph(code, pixels, figures);
        draw(code, g, static_cast<int>(std::lround(x)));
        x += g.advance;
    }
    return x;
}

void paint(Image& image, const Bitmap& b, int penX, int penY, const Color& color) {
    const int left = penX + b.left, top = penY + b.top;
    const int x0 = std::max(-left, 0), x1 = std::min(b.width, image.width - left);
    const int y0 = std::max(-top, 0), y1 = std::min(b.height, image.height - top);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const unsigned char cover = b.cover[y * b.width + x];
            if (cover > 0)
                blend(image.at(left + x, top + y), color, static_cast<float>(cover) / 255.0f);
        }
}

/// A light halo for dark letters, a dark one for light letters.
Color haloColorOf(const Color& color) {
    const bool dark = color.r + color.g + color.b < 1.5f;
    return dark ? Color{1, 1, 1, 1} : Color{0.05f, 0.05f, 0.06f, 1};
}

}  // namespace

float textWidth(const std::string& text, float pixels, Figures figures) {
    return walk(text, static_cast<int>(std::lround(pixels)), 0, figures, [](int, const Glyph&, int) {});
}

float textAscent(int pixels) { return kAscentShare * static_cast<float>(pixels); }

bool hasLetter(int codepoint) { return font().has(codepoint); }

LetterExtent letterExtent(int codepoint, bool italic) {
    return font().faceOf(codepoint, italic).extent(codepoint);
}

void drawLetter(Image& image, const FormulaLetter& letter, float pixels, Point at, const Color& color) {
    const float most = 4.0f * static_cast<float>(image.width + image.height);
    if (!(std::abs(at.x) <= most && std::abs(at.y) <= most)) return;
    constexpr float kBold = 0.045f;  // em: a bold letter is drawn twice, this far apart
    const Face& face = font().faceOf(letter.codepoint, letter.italic);
    const float scale = face.scale(letter.size * pixels);
    const int x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::lround(at.y));
    Bitmap ink = face.bitmap(letter.codepoint, scale, at.x - std::floor(at.x), letter.stretch);
    if (letter.bold) {
        const float shift = at.x - std::floor(at.x) + kBold * letter.size * pixels;
        Bitmap second = face.bitmap(letter.codepoint, scale, shift - std::floor(shift), letter.stretch);
        second.left += static_cast<int>(std::floor(shift));
        paint(image, second, x, y, color);
    }
    paint(image, ink, x, y, color);
}

void drawHaloed(Image& image, const std::string& text, int pixels, float x, float baseline,
                const Color& color) {
    const int y = static_cast<int>(std::lround(baseline));
    const Color halo = haloColorOf(color);
    walk(text, pixels, x, Figures::proportional, [&](int code, const Glyph&, int pen) {
        paint(image, font().halo(code, pixels), pen, y, halo);
    });
    walk(text, pixels, x, Figures::proportional,
         [&](int, const Glyph& g, int pen) { paint(image, g.ink, pen, y, color); });
}

void drawLabel(Image& image, const std::string& text, Point at, Anchor anchor, float pixels,
               const Color& color, Figures figures) {
    const float most = 4.0f * static_cast<float>(image.width + image.height);
    if (!(std::abs(at.x) <= most && std::abs(at.y) <= most && pixels >= 1.0f && pixels <= most))
        return;  // not finite, or far outside the picture
    const float width = anchor == Anchor::start ? 0.0f : textWidth(text, pixels, figures);
    const float x = at.x - (anchor == Anchor::end ? width : 0.5f * width);
    const int y = static_cast<int>(std::lround(at.y));
    walk(text, static_cast<int>(std::lround(pixels)), x, figures,
         [&](int, const Glyph& g, int pen) { paint(image, g.ink, pen, y, color); });
}

}  // namespace render
