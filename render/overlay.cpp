#include "render/overlay.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/coverage.h"

namespace render {
namespace {

constexpr float kFaintArrow = 0.3f;  // opacity of an arrow that starts behind something
constexpr std::size_t kCrowd = 100;  // with more arrows than this, the hidden ones only confuse

/// A light rim for marks on a light background, a dark one on a dark background.
Color rimOf(const Look& look) {
    const bool light = look.skyTop.g > 0.4f;
    return light ? Color{1, 1, 1, 0.8f} : Color{0.03f, 0.03f, 0.04f, 0.7f};
}

/// The radius in pixels, at least 1.2.
float radiusOf(const Marker& marker, const Projected& p, const Image& image, const View& view,
               const Look& look) {
    const float wanted = marker.pixels * overlayScale(look, image.width, image.height);
    if (marker.largest <= 0.0f) return std::max(wanted, 1.2f);
    const float pixelsPerMeter =
        0.5f * static_cast<float>(image.height) * view.projection(1, 1) / p.depth;
    return std::max(std::min(wanted, marker.largest * pixelsPerMeter), 1.2f);
}

/// The usual symbol of a centre of mass: quarters of ink and white.
void drawQuartered(Image& image, const Vec2& c, float r, const Color& color) {
    const Vec2 reach(r, r);
    const float rim = std::max(0.14f * r, 0.8f);
    fill(image, c - reach, c + reach, {{1, 1, 1, 1}, color, rim},
         [&](const Vec2& q) { return (q - c).norm() - r; });
    fill(image, c - reach, c + reach, {color, {}, 0.0f}, [&](const Vec2& q) {
        const Vec2 d = q - c;
        const float away = std::min(std::abs(d.x()), std::abs(d.y()));
        const float quarter = d.x() * d.y() < 0.0f ? -away : away;
        return std::max(d.norm() - r, quarter);
    });
}

struct FlatArrow {
    Vec2 from, to;
    Color color;
    float depth;  // m
};

}  // namespace

bool isHidden(const Projected& p, float reach, const Image& image, const DepthMap& depth) {
    if (p.x < 0 || p.y < 0 || p.x >= static_cast<float>(image.width) ||
        p.y >= static_cast<float>(image.height))
        return false;
    const float there = metersAt(depth, image, static_cast<int>(p.x), static_cast<int>(p.y));
    // A contact lies between two surfaces, so its own body may be a little in front of it.
    return there < 0.985f * p.depth - 0.02f - reach;
}

void drawMarkers(Image& image, const Frame& frame, const View& view, const DepthMap& depth) {
    const Color rim = rimOf(frame.look);
    for (const Marker& marker : frame.markers) {
        const Projected p = project(view, marker.position, image.width, image.height);
        if (p.depth <= 0 || isHidden(p, marker.reach, image, depth)) continue;
        const float r = radiusOf(marker, p, image, view, frame.look);
        const Vec2 c(p.x, p.y), reach(r, r);
        if (marker.shape == MarkerShape::quartered)
            drawQuartered(image, c, r, marker.color);
        else
            fill(image, c - reach, c + reach, {marker.color, rim, r < 2.0f ? 0.0f : 0.25f * r},
                 [&](const Vec2& q) { return (q - c).norm() - r; });
    }
}

/// The shaft grows towards the head, so that the direction is visible along all of it.
void drawFlatArrow(Image& image, const Vec2& from, const Vec2& to, const Color& color,
                   const Look& look) {
    const float length = (to - from).norm();
    const float scale = overlayScale(look, image.width, image.height);
    if (length < 2.0f * scale) return;
    const float half = std::clamp(0.035f * length, 0.9f * scale, 1.9f * scale);
    const float head = std::min(6.0f * half, 0.6f * length);
    const Vec2 way = (to - from) / length, side(-way.y(), way.x());
    const Vec2 neck = to - head * way, reach(0.5f * head, 0.5f * head);
    const float slope = 0.4f,
                cosine = 1.0f / std::sqrt(1.0f + slope * slope);  // of the head's sides
    Color rim = rimOf(look);
    if (color.a < 1.0f) rim.a = 0.0f;  // it would show through the arrow
    fill(image, from.cwiseMin(to) - reach, from.cwiseMax(to) + reach, {color, rim, 0.55f * half},
         [&](const Vec2& q) {
             float along = 0.0f;
             const float off = toSegment(q, from, neck, along);
             const float shaft = off - half * (0.45f + 0.55f * along);
             const float ahead = (q - neck).dot(way), aside = std::abs((q - neck).dot(side));
             return std::min(shaft, std::max(-ahead, (aside - slope * (head - ahead)) * cosine));
         });
}

void drawArrows(Image& image, const Frame& frame, const View& view, const DepthMap& depth) {
    std::vector<FlatArrow> arrows;
    for (const Arrow& arrow : frame.arrows) {
        const Projected from = project(view, arrow.from, image.width, image.height);
        const Projected to = project(view, arrow.to, image.width, image.height);
        if (from.depth <= 0 || to.depth <= 0) continue;
        const bool hidden = isHidden(from, arrow.reach, image, depth);
        if (hidden && frame.arrows.size() > kCrowd) continue;
        arrows.push_back({{from.x, from.y}, {to.x, to.y}, arrow.color, from.depth});
        if (hidden) arrows.back().color.a *= kFaintArrow;
    }
    std::stable_sort(arrows.begin(), arrows.end(),
                     [](const FlatArrow& a, const FlatArrow& b) { return a.depth > b.depth; });
    for (const FlatArrow& arrow : arrows)
        drawFlatArrow(image, arrow.from, arrow.to, arrow.color, frame.look);
}

bool needsDepth(const Frame& frame) {
    return !(frame.markers.empty() && frame.arrows.empty() && frame.lines.empty() &&
             frame.labels.empty());
}

void drawOverlays(Image& image, const Frame& frame, const View& view, const Scenery& scenery) {
    drawGhosts(image, frame, view, scenery.surfaces);
    drawLines(image, frame, view, scenery.depth);
    drawMarkers(image, frame, view, scenery.depth);
    drawArrows(image, frame, view, scenery.depth);
    drawTexts(image, frame, view, scenery.depth);
}

}  // namespace render
