#include "render/overlay.h"

#include <algorithm>
#include <cmath>

#include "render/blend.h"

namespace render {
namespace {

using Vec2 = Eigen::Vector2f;

/// Distance from p to the segment a-b.
float toSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 ab = b - a;
    const float square = ab.squaredNorm();
    const float t = square > 0 ? std::clamp((p - a).dot(ab) / square, 0.0f, 1.0f) : 0.0f;
    return (p - a - t * ab).norm();
}

/// Signed distance to a triangle given counter-clockwise or clockwise; negative inside.
float toTriangle(const Vec2& p, const Vec2 (&corner)[3]) {
    float edge = 1e9f;
    bool inside = true;
    const float area = (corner[1] - corner[0]).x() * (corner[2] - corner[0]).y() -
                       (corner[1] - corner[0]).y() * (corner[2] - corner[0]).x();
    for (int i = 0; i < 3; ++i) {
        const Vec2 &a = corner[i], &b = corner[(i + 1) % 3];
        edge = std::min(edge, toSegment(p, a, b));
        const float cross = (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
        inside = inside && cross * area >= 0;
    }
    return inside ? -edge : edge;
}

/// Fills where `distance` (pixels, negative inside) is below zero, with a rim of another colour.
template <class Distance>
void fill(Image& image, Vec2 low, Vec2 high, const Color& color, const Color& rim, float rimWidth,
          Distance distance) {
    const int x0 = std::max(static_cast<int>(std::floor(low.x() - rimWidth - 1)), 0);
    const int y0 = std::max(static_cast<int>(std::floor(low.y() - rimWidth - 1)), 0);
    const int x1 = std::min(static_cast<int>(std::ceil(high.x() + rimWidth + 1)), image.width - 1);
    const int y1 = std::min(static_cast<int>(std::ceil(high.y() + rimWidth + 1)), image.height - 1);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const float d = distance(Vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
            blend(image.at(x, y), rim, std::clamp(0.5f - (d - rimWidth), 0.0f, 1.0f));
            blend(image.at(x, y), color, std::clamp(0.5f - d, 0.0f, 1.0f));
        }
}

float scaleOf(const Image& image) { return static_cast<float>(image.height) / 720.0f; }

/// True when the picture shows something clearly nearer at that place. A contact lies between two
/// surfaces, so a little in front of it is its own body.
bool isHidden(const Projected& p, const Image& image, const DepthMap& depth) {
    if (depth.meters.empty() || p.x < 0 || p.y < 0) return false;
    const int x = static_cast<int>(p.x) * depth.width / image.width;
    const int y = static_cast<int>(p.y) * depth.height / image.height;
    return x < depth.width && y < depth.height && depth.at(x, y) < 0.985f * p.depth - 0.02f;
}

constexpr Color kRim{1.0f, 1.0f, 1.0f, 0.75f};

}  // namespace

void drawMarkers(Image& image, const Frame& frame, const View& view, const DepthMap& depth) {
    for (const Marker& marker : frame.markers) {
        const Projected p = project(view, marker.position, image.width, image.height);
        if (p.depth <= 0 || isHidden(p, image, depth)) continue;
        const float r = std::max(marker.pixels * scaleOf(image), 1.2f);
        const Vec2 c(p.x, p.y), reach(r, r);
        fill(image, c - reach, c + reach, marker.color, kRim, 0.25f * r,
             [&](const Vec2& q) { return (q - c).norm() - r; });
    }
}

void drawArrows(Image& image, const Frame& frame, const View& view) {
    for (const Arrow& arrow : frame.arrows) {
        const Projected from = project(view, arrow.from, image.width, image.height);
        const Projected to = project(view, arrow.to, image.width, image.height);
        if (from.depth <= 0 || to.depth <= 0) continue;
        const Vec2 a(from.x, from.y), b(to.x, to.y);
        const float length = (b - a).norm();
        if (length < 1.0f) continue;
        const float half = std::max(1.5f * scaleOf(image), 0.8f);
        const float head = std::min(8.5f * half / 1.5f, 0.6f * length);
        const Vec2 way = (b - a) / length, side(-way.y(), way.x());
        const Vec2 neck = b - head * way;
        const Vec2 tip[3] = {b, neck + 0.42f * head * side, neck - 0.42f * head * side};
        const Vec2 reach(head + half, head + half);
        fill(image, a.cwiseMin(b) - reach, a.cwiseMax(b) + reach, arrow.color, kRim, 0.6f * half,
             [&](const Vec2& q) { return std::min(toSegment(q, a, neck) - half, toTriangle(q, tip)); });
    }
}

}  // namespace render
