// Texts and plates in the corners, then the names, the nearest first.
#include <algorithm>
#include <cmath>

#include "render/canvas.h"
#include "render/corners.h"
#include "render/coverage.h"
#include "render/formula_lines.h"
#include "render/label_places.h"
#include "render/overlay.h"
#include "render/plate.h"

namespace render {
namespace {

constexpr float kLeastOpacity = 0.88f;  // of a text's plate: legible over black and over white

void drawLine(Image& image, const PlacedText& text, const std::string& line, int pixels, float y,
              const Color& color) {
    const float left = text.box.x + text.pad, right = text.box.x + text.box.width - text.pad;
    const float x = text.right ? right - lineWidth(line, text.formulas, pixels) : left;
    const float base = y + textAscent(pixels);
    if (text.pad > 0.0f || !text.formulas.empty())
        drawFormulaLine(image, line, text.formulas, pixels, {x, std::round(base)}, color);
    else
        drawHaloed(image, line, pixels, x, base, color);
}

void drawTextPlate(Image& image, const PlacedText& text, const Look& look) {
    const Box& box = text.box;
    const Vec2 low(box.x, box.y), high(box.x + box.width, box.y + box.height);
    Color color = look.plate;
    color.a = std::max(color.a, kLeastOpacity);
    fill(image, low, high, {color, {}, 0.0f},
         [&](const Vec2& q) { return toRoundedBox(q, low, high, 0.5f * text.pad); });
}

void drawText(Image& image, const PlacedText& text, const Look& look) {
    if (text.pad > 0.0f) drawTextPlate(image, text, look);
    float y = text.box.y + text.pad;
    if (!text.heading.empty())
        drawLine(image, text, text.heading, text.headingPixels, y, text.headingColor);
    y += text.headingHeight;
    for (const std::string& line : text.lines) {
        drawLine(image, text, line, text.pixels, y + text.above, text.color);
        y += text.lineHeight;
    }
}

struct SeenLabel {
    const Label* label;
    Projected at;
};

std::vector<SeenLabel> seenLabels(const Image& image, const Frame& frame, const View& view,
                                  const DepthMap& depth) {
    std::vector<SeenLabel> seen;
    for (const Label& label : frame.labels) {
        const Projected p = project(view, label.position, image.width, image.height);
        if (p.depth > 0 && !label.text.empty() && !isHidden(p, label.reach, image, depth))
            seen.push_back({&label, p});
    }
    std::stable_sort(seen.begin(), seen.end(), [](const SeenLabel& a, const SeenLabel& b) {
        if (a.label->beside || b.label->beside) return a.label->beside && !b.label->beside;
        return a.at.depth < b.at.depth;
    });
    return seen;
}

/// `reach`: of the body, in pixels.
int namePixels(const Label& label, float reach, float scale, const Look& look) {
    const bool given = look.unit > 0.0f;
    const float wanted = given ? label.size * scale : std::min(label.size * scale, 0.4f * reach);
    return std::max(static_cast<int>(std::lround(wanted)), given ? 1 : kSmallestText);
}

constexpr float kSubscript = 0.72f;  // of the text's size
constexpr float kLowered = 0.24f;    // of the text's size

int subscriptPixels(int pixels) {
    return std::max(static_cast<int>(std::lround(kSubscript * static_cast<float>(pixels))), 1);
}

float labelWidth(const Label& label, int pixels) {
    const float size = static_cast<float>(pixels);
    return textWidth(label.text, size) + textWidth(label.value, size) +
           textWidth(label.subscript, static_cast<float>(subscriptPixels(pixels)));
}

void drawName(Image& image, const Label& label, int pixels, float x, float base,
              const Color& color) {
    const int small = subscriptPixels(pixels);
    const float size = static_cast<float>(pixels);
    drawHaloed(image, label.text, pixels, x, base, color);
    x += textWidth(label.text, size);
    drawHaloed(image, label.subscript, small, x, base + kLowered * size, color);
    x += textWidth(label.subscript, static_cast<float>(small));
    drawHaloed(image, label.value, pixels, x, base, color);
}

/// From a name's nearer side to its point.
void drawLeader(Image& image, const Box& box, const Projected& at, float scale, const Color& color) {
    const float middle = box.y + 0.5f * box.height, gap = 0.15f * box.height;
    const float left = box.x - gap, right = box.x + box.width + gap;
    const bool beside = at.x < left || at.x > right;
    const Point from = beside ? Point{at.x < left ? left : right, middle}
                              : Point{box.x + 0.5f * box.width,
                                      at.y < box.y ? box.y : box.y + box.height};
    const Point line[] = {from, {at.x, at.y}};
    drawPolyline(image, line, 3.0f * scale, {1.0f, 1.0f, 1.0f, 0.6f});
    drawPolyline(image, line, 1.3f * scale, color);
}

/// False: there is no room.
bool takePlace(LabelPlaces& places, const Label& label, float reach, Box& box) {
    return label.beside ? places.takeBeside(box) : places.takeOver(box, 0.4f * reach);
}

void drawLabels(Image& image, const Frame& frame, const View& view, const DepthMap& depth,
                const CornerLayout& corners) {
    LabelPlaces places(image, frame, view, corners);
    const float scale = overlayScale(frame.look, image.width, image.height);
    for (const SeenLabel& seen : seenLabels(image, frame, view, depth)) {
        const Label& label = *seen.label;
        const float reach = label.reach > 0.0f
                                ? label.reach * view.projection(1, 1) * 0.5f *
                                      static_cast<float>(image.height) / seen.at.depth
                                : 1e6f;  // pixels
        const int pixels = namePixels(label, reach, scale, frame.look);
        const float width = labelWidth(label, pixels);
        const float height = 1.1f * static_cast<float>(pixels), pad = 0.1f * height;
        Box box{seen.at.x - 0.5f * width - pad, seen.at.y + (label.below - 0.5f) * height,
                width + 2.0f * pad, height};
        const Color color = label.color.a > 0.0f ? label.color : frame.look.ink;
        const Box wanted = box;
        if (!label.clearOf.empty() && places.takeOutside(box, label.clearOf, view)) {
            drawLeader(image, box, seen.at, scale, color);
        } else {
            box = wanted;
            if (!takePlace(places, label, reach, box)) continue;
        }
        drawName(image, label, pixels, box.x + pad, box.y + textAscent(pixels), color);
    }
}

}  // namespace

void drawTexts(Image& image, const Frame& frame, const View& view, const DepthMap& depth) {
    const CornerLayout corners = layoutCorners(frame, image.width, image.height);
    const float meter = pixelsPerMeter(frame.camera, image.height);
    for (const PlacedPlate& plate : corners.plates) drawPlate(image, plate, frame.look, meter);
    for (const PlacedText& text : corners.texts) drawText(image, text, frame.look);
    drawLabels(image, frame, view, depth, corners);
}

}  // namespace render
