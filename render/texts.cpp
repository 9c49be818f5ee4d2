// Texts and plates in the corners, then the names, the nearest first.
#include <algorithm>
#include <cmath>

#include "render/canvas.h"
#include "render/corners.h"
#include "render/coverage.h"
#include "render/overlay.h"
#include "render/plate.h"

namespace render {
namespace {

constexpr float kLeastOpacity = 0.88f;  // of a text's plate: legible over black and over white

void drawLine(Image& image, const PlacedText& text, const std::string& line, int pixels, float y,
              const Color& color) {
    const float size = static_cast<float>(pixels);
    const float left = text.box.x + text.pad, right = text.box.x + text.box.width - text.pad;
    const float x = text.right ? right - textWidth(line, size) : left;
    const float base = y + textAscent(pixels);
    if (text.pad > 0.0f)
        drawLabel(image, line, {x, std::round(base)}, Anchor::start, size, color);
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
        drawLine(image, text, line, text.pixels, y, text.color);
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
        return a.at.depth < b.at.depth;
    });
    return seen;
}

/// Finds a place for a name: at its point, or a line above or below it if that is at most `most`
/// pixels away; entirely within the picture.
bool findPlace(Box& box, float most, const Image& image, const CornerLayout& corners,
               const std::vector<Box>& taken) {
    const float y = box.y;
    for (const float shift : {0.0f, -box.height, box.height}) {
        if (std::abs(shift) > most) continue;
        box.y = y + shift;
        const bool within = box.x >= 0.0f && box.y >= 0.0f &&
                            box.x + box.width <= static_cast<float>(image.width) &&
                            box.y + box.height <= static_cast<float>(image.height);
        const auto meets = [&](const Box& other) { return other.overlaps(box); };
        if (within && corners.isFree(box) && std::none_of(taken.begin(), taken.end(), meets))
            return true;
    }
    return false;
}

/// `reach`: of the body, in pixels.
int namePixels(const Label& label, float reach, float scale, const Look& look) {
    const bool given = look.unit > 0.0f;
    const float wanted = given ? label.size * scale : std::min(label.size * scale, 0.4f * reach);
    return std::max(static_cast<int>(std::lround(wanted)), given ? 1 : kSmallestText);
}

void drawLabels(Image& image, const Frame& frame, const View& view, const DepthMap& depth,
                const CornerLayout& corners) {
    std::vector<Box> taken;
    const float scale = overlayScale(frame.look, image.width, image.height);
    for (const SeenLabel& seen : seenLabels(image, frame, view, depth)) {
        const Label& label = *seen.label;
        const float reach = label.reach > 0.0f
                                ? label.reach * view.projection(1, 1) * 0.5f *
                                      static_cast<float>(image.height) / seen.at.depth
                                : 1e6f;  // pixels
        const int pixels = namePixels(label, reach, scale, frame.look);
        const float width = textWidth(label.text, static_cast<float>(pixels));
        const float height = 1.1f * static_cast<float>(pixels), pad = 0.1f * height;
        Box box{seen.at.x - 0.5f * width - pad, seen.at.y + (label.below - 0.5f) * height,
                width + 2.0f * pad, height};
        if (!findPlace(box, 0.4f * reach, image, corners, taken)) continue;
        taken.push_back(box);
        drawHaloed(image, label.text, pixels, box.x + pad, box.y + textAscent(pixels),
                   frame.look.ink);
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
