#include "render/corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/coverage.h"
#include "render/formula_lines.h"
#include "render/glyphs.h"

namespace render {
namespace {

struct Margins {
    float side, width, height;
    const Look& look;
    float right() const { return width - side; }
    float bottom() const { return height - side; }
};

bool isRight(Corner c) { return c == Corner::topRight || c == Corner::bottomRight; }
bool isBottom(Corner c) { return c == Corner::bottomLeft || c == Corner::bottomRight; }

/// In its corner, or as near to it as the others allow, moved up or down.
std::optional<Box> placed(float width, float height, Corner corner, float gap,
                          const CornerLayout& layout, const Margins& m) {
    Box box{isRight(corner) ? m.right() - width : m.side,
            isBottom(corner) ? m.bottom() - height : m.side, width, height};
    const float step = std::max(gap, 1.0f);
    for (; box.y >= m.side - 0.5f && box.y + height <= m.bottom() + 0.5f;
         box.y += isBottom(corner) ? -step : step) {
        const Box roomy{box.x - gap, box.y - 0.5f * gap, box.width + 2.0f * gap, box.height + gap};
        if (layout.isFree(roomy)) return box;
    }
    return std::nullopt;
}

int pixelsOf(float size, const Margins& m, float share = 1.0f) {
    return textPixels(share * size, m.look, static_cast<int>(m.width), static_cast<int>(m.height));
}

/// By how much letters may shrink to fit; letters of a fixed size do not.
std::span<const float> sharesOf(std::span<const float> all, const Look& look) {
    return look.unit > 0.0f ? all.first(1) : all;
}
constexpr float kTextShares[] = {1.0f, 0.8f, 0.65f}, kPlateShares[] = {1.0f, 0.85f, 0.7f};
constexpr float kHeadingShare = 0.8f;  // of the text's letters

/// Removes the last UTF-8 letter.
void dropLetter(std::string& text) {
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80)
        text.pop_back();
    if (!text.empty()) text.pop_back();
}

/// A heading has one line: it is left out if it is wider than the room.
void addHeading(const Text& text, const Margins& m, float room, PlacedText& p) {
    const bool given = m.look.unit > 0.0f, small = !given && p.pixels <= kSmallestText;
    const float wanted = std::round(kHeadingShare * static_cast<float>(p.pixels));
    const float pixels = given ? wanted : std::max(wanted, static_cast<float>(kSmallestText));
    if (text.heading.empty() || small || textWidth(text.heading, pixels) > room) return;
    p.heading = text.heading;
    p.headingPixels = static_cast<int>(pixels);
    p.headingHeight = std::round(1.3f * pixels);
    p.headingColor = text.headingColor;
}

PlacedText linesOf(const Text& text, float share, const Margins& m) {
    PlacedText p;
    p.pixels = pixelsOf(text.size, m, share);
    const bool tight = text.needed && p.pixels <= kSmallestText;
    p.pad = text.plate ? std::round((tight ? 0.25f : 0.5f) * static_cast<float>(p.pixels)) : 0.0f;
    const float room = m.right() - m.side - 2.0f * p.pad;
    p.formulas = text.formulas;
    p.lines = brokenText(text.text, p.pixels, room, p.formulas);
    LineReach reach;
    for (const std::string& line : p.lines) {
        const LineReach one = lineReach(line, p.formulas, p.pixels);
        reach = {std::max(reach.above, one.above), std::max(reach.below, one.below)};
    }
    p.above = std::round(reach.above);
    p.lineHeight = std::round(1.2f * static_cast<float>(p.pixels)) + p.above + std::round(reach.below);
    p.right = isRight(text.corner);
    p.color = text.color;
    addHeading(text, m, room, p);
    return p;
}

float widthOf(const PlacedText& p) {
    float width = textWidth(p.heading, static_cast<float>(p.headingPixels));
    for (const std::string& line : p.lines)
        width = std::max(width, lineWidth(line, p.formulas, p.pixels));
    return width + 2.0f * p.pad;
}

/// A plate of the smallest letters that would still hide the scene.
bool hidesTooMuch(const PlacedText& p, float height, const Margins& m) {
    constexpr float kMost = 1.0f / 8.0f;  // of the picture's height
    return m.look.unit <= 0.0f && p.pad > 0.0f && p.pixels <= kSmallestText && height > kMost * m.height;
}

void addText(const Text& text, const Margins& m, CornerLayout& layout) {
    const std::span<const float> shares = sharesOf(kTextShares, m.look);
    for (const float share : shares) {
        PlacedText p = linesOf(text, share, m);
        if (p.lines.size() > 2 && share != shares.back() && p.pixels > kSmallestText) continue;
        const float height =
            p.headingHeight + p.lineHeight * static_cast<float>(p.lines.size()) + 2.0f * p.pad;
        if (!text.needed && hidesTooMuch(p, height, m)) continue;
        const float gap = 0.2f * static_cast<float>(p.pixels);
        const auto box = placed(widthOf(p), height, text.corner, gap, layout, m);
        if (!box) continue;
        p.box = *box;
        layout.texts.push_back(std::move(p));
        return;
    }
}

void addPlate(const Plate& plate, const Frame& frame, const Margins& m, CornerLayout& layout) {
    const float meter = pixelsPerMeter(frame.camera, static_cast<int>(m.height));
    for (const float share : sharesOf(kPlateShares, m.look)) {
        const PlateMetrics metrics = metricsOf(plate, pixelsOf(plate.size, m, share), meter);
        if (metrics.width > m.right() - m.side) continue;
        const float gap = 0.4f * static_cast<float>(metrics.pixels);
        const auto box = placed(metrics.width, metrics.height, plate.corner, gap, layout, m);
        if (!box) continue;
        layout.plates.push_back({*box, metrics, &plate});
        return;
    }
}

}  // namespace

float cornerMargin(int width, int height) {
    return 0.033f * static_cast<float>(std::min(width, height));
}

int textPixels(float size, const Look& look, int width, int height) {
    const int pixels = static_cast<int>(std::lround(size * overlayScale(look, width, height)));
    return std::max(pixels, look.unit > 0.0f ? 1 : kSmallestText);
}

bool CornerLayout::isFree(const Box& box) const {
    const auto meets = [&](const auto& item) { return item.box.overlaps(box); };
    return std::none_of(texts.begin(), texts.end(), meets) &&
           std::none_of(plates.begin(), plates.end(), meets);
}

std::vector<std::string> brokenText(const std::string& text, int pixels, float room,
                                    std::span<const Formula> formulas) {
    const auto fits = [&](const std::string& line) { return lineWidth(line, formulas, pixels) <= room; };
    if (fits(text)) return {text};
    std::vector<std::string> lines(1);
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find(' ', start), text.size());
        std::string word = text.substr(start, end - start);
        start = end + 1;
        if (word.empty()) continue;
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (fits(longer)) {
            lines.back() = longer;
            continue;
        }
        if (!fits(word)) {
            while (!word.empty() && !fits(word + "…")) dropLetter(word);
            word += "…";
        }
        if (lines.back().empty())
            lines.back() = word;
        else
            lines.push_back(word);
    }
    return lines;
}

float pixelsPerMeter(const Camera& camera, int height) {
    const float half = std::tan(camera.fovDegrees * std::numbers::pi_v<float> / 360.0f);
    const float distance = std::max((camera.from - camera.lookAt).norm(), 1e-3f);
    return 0.5f * static_cast<float>(height) / (half * distance);
}

CornerLayout layoutCorners(const Frame& frame, int width, int height) {
    const Margins m{cornerMargin(width, height), static_cast<float>(width),
                    static_cast<float>(height), frame.look};
    CornerLayout layout;
    // The last text of a lower corner is at the bottom.
    for (const Text& text : frame.texts)
        if (!isBottom(text.corner) && !text.text.empty()) addText(text, m, layout);
    for (auto text = frame.texts.rbegin(); text != frame.texts.rend(); ++text)
        if (isBottom(text->corner) && !text->text.empty()) addText(*text, m, layout);
    for (const Plate& plate : frame.plates)
        if (!plate.rows.empty()) addPlate(plate, frame, m, layout);
    return layout;
}

}  // namespace render
