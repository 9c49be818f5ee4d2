#include "demos/look/inks.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "demos/look/theme.h"
#include "render/palette.h"

namespace demos {
namespace {

using render::Color;

constexpr double kLineContrast = 3.0;  // WCAG 2.1, 1.4.11: graphics
constexpr double kTextContrast = 4.5;  // and 1.4.3: text

/// A colour of the palette (-1: the background), and the share of ink mixed in.
struct LineInk {
    int palette;
    float share;
};
/// Blue, vermilion, green, pink, ink, brown: at least 12 apart in CIE L*a*b*, also for red-blind
/// and green-blind viewers. Sky blue and orange are missing: dark enough for white paper, they look
/// like blue and vermilion. Then darker ones of the same, for lines distinguished by their labels.
constexpr LineInk kLines[] = {{0, 0.0f},   {5, 0.0f},  {2, 0.0f},  {3, 0.0f},
                              {-1, 0.85f}, {1, 0.5f},  {0, 0.45f}, {5, 0.45f},
                              {2, 0.45f},  {3, 0.45f}, {4, 0.0f},  {1, 0.0f}};

Color mix(const Color& a, const Color& b, float share) {
    return {a.r + share * (b.r - a.r), a.g + share * (b.g - a.g), a.b + share * (b.b - a.b), 1.0f};
}

double linear(float channel) {
    const double c = static_cast<double>(channel);
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(const Color& c) {
    return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

/// The colour, mixed with ink until it has enough contrast.
Color visible(const Color& color, const Inks& inks, double least) {
    Color seen = color;
    for (int i = 1; i <= 20 && contrast(seen, inks.ground) < least; ++i)
        seen = mix(color, inks.ink, 0.05f * static_cast<float>(i));
    return seen;
}

Color baseColor(int i, const Inks& inks) {
    const LineInk line = kLines[static_cast<std::size_t>(i) % std::size(kLines)];
    const Color color = line.palette < 0 ? inks.ground : render::paletteColor(line.palette);
    return mix(color, inks.ink, line.share);
}

}  // namespace

Inks inksOf(const std::string& theme) {
    render::Frame frame;
    frame.texts.push_back({});
    applyTheme(theme, frame);
    Inks inks;
    inks.ink = frame.texts.front().color;
    inks.ground = frame.look.skyTop;
    if (theme != "dark" && theme != "print")
        inks.ground = mix(inks.ground, {1, 1, 1, 1}, 0.85f);  // paler than a sky
    inks.muted = mix(inks.ground, inks.ink, 0.68f);
    inks.grid = mix(inks.ground, inks.ink, 0.13f);
    inks.axis = mix(inks.ground, inks.ink, 0.55f);
    return inks;
}

render::Color lineColor(int i, const Inks& inks) {
    return visible(baseColor(i, inks), inks, kLineContrast);
}

render::Color labelColor(int i, const Inks& inks) {
    return visible(baseColor(i, inks), inks, kTextContrast);
}

double contrast(const render::Color& a, const render::Color& b) {
    const double la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace demos
