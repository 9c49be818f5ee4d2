// Thin lines over the picture; pixels with something in front of them are faint.
#include "render/coverage.h"
#include "render/overlay.h"

namespace render {
namespace {

constexpr float kFaintLine = 0.22f;  // opacity where the line is behind something

/// A line in the picture; 1 / depth changes linearly along it.
struct FlatLine {
    Vec2 a, b;
    float nearA = 0, nearB = 0;  // 1 / depth: 1/m
};

/// Finds the part in front of the camera; false if there is none.
bool flatten(const Line& line, const View& view, const Image& image, FlatLine& flat) {
    const auto depthOf = [&](const Vec3& p) {
        return -(view.view.block<1, 3>(2, 0) * p)(0) - view.view(2, 3);
    };
    const float least = 1.01f * view.nearest;
    Vec3 from = line.from, to = line.to;
    const float before = depthOf(from), after = depthOf(to);
    if (before < least && after < least) return false;
    const Vec3 cut = from + (least - before) / (after - before) * (to - from);
    if (before < least) from = cut;
    if (after < least) to = cut;
    const Projected a = project(view, from, image.width, image.height);
    const Projected b = project(view, to, image.width, image.height);
    if (a.depth <= 0 || b.depth <= 0) return false;
    flat = {{a.x, a.y}, {b.x, b.y}, 1.0f / a.depth, 1.0f / b.depth};
    return true;
}

/// Walks along the longer axis and draws the few pixels across.
void draw(Image& image, const FlatLine& l, float half, const Color& color, const DepthMap& depth) {
    const Vec2 way = l.b - l.a;
    const int major = std::abs(way.x()) >= std::abs(way.y()) ? 0 : 1, minor = 1 - major;
    if (std::abs(way[major]) < 1e-3f) return;
    const float reach = (half + 1.0f) * way.norm() / std::abs(way[major]);
    const Vec2 aside = Vec2::Unit(minor) * reach;
    const PixelRange range = pixelsWithin(image, l.a.cwiseMin(l.b), l.a.cwiseMax(l.b));
    const int first = major == 0 ? range.x0 : range.y0, last = major == 0 ? range.x1 : range.y1;
    for (int i = first; i <= last; ++i) {
        const float t = (static_cast<float>(i) + 0.5f - l.a[major]) / way[major];
        if (t < 0.0f || t > 1.0f) continue;
        const Vec2 at = l.a + t * way;
        const float meters = 1.0f / (l.nearA + t * (l.nearB - l.nearA));
        const PixelRange across = pixelsWithin(image, at - aside, at + aside);
        const int low = major == 0 ? across.y0 : across.x0,
                  high = major == 0 ? across.y1 : across.x1;
        for (int j = low; j <= high; ++j) {
            const int x = major == 0 ? i : j, y = major == 0 ? j : i;
            float along = 0.0f;
            const float d = toSegment(centreOf(x, y), l.a, l.b, along) - half;
            if (d >= 0.5f) continue;
            const bool behind = metersAt(depth, image, x, y) < 0.995f * meters - 0.01f;
            blend(image.at(x, y), color,
                  std::clamp(0.5f - d, 0.0f, 1.0f) * (behind ? kFaintLine : 1.0f));
        }
    }
}

}  // namespace

void drawLines(Image& image, const Frame& frame, const View& view, const DepthMap& depth) {
    const float scale = overlayScale(frame.look, image.width, image.height);
    for (const Line& line : frame.lines) {
        FlatLine flat;
        if (flatten(line, view, image, flat))
            draw(image, flat, 0.5f * std::max(line.pixels * scale, 1.0f), line.color, depth);
    }
}

}  // namespace render
