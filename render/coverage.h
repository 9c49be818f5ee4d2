/// Fills shapes on a picture by their signed distance (pixels, negative inside). A pixel's coverage
/// is 0.5 minus the signed distance of its centre from the edge, clamped to 0..1.
#pragma once
#include <algorithm>
#include <cmath>

#include "render/blend.h"
#include "render/frame.h"
#include "render/image.h"

namespace render {

using Vec2 = Eigen::Vector2f;

/// Pixels low..high inclusive, within the picture.
struct PixelRange {
    int x0 = 0, y0 = 0, x1 = -1, y1 = -1;
};
inline PixelRange pixelsWithin(const Image& image, const Vec2& low, const Vec2& high) {
    const auto at = [](float v, int most) {
        return static_cast<int>(std::clamp(v, -1.0f, static_cast<float>(most) + 1.0f));
    };
    PixelRange range;
    range.x0 = std::max(at(std::floor(low.x()), image.width), 0);
    range.y0 = std::max(at(std::floor(low.y()), image.height), 0);
    range.x1 = std::min(at(std::ceil(high.x()), image.width), image.width - 1);
    range.y1 = std::min(at(std::ceil(high.y()), image.height), image.height - 1);
    return range;
}

inline Vec2 centreOf(int x, int y) {
    return {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
}

/// The fill colour of a shape, and the rim around it.
struct Paint {
    Color color, rim;
    float rimWidth = 0.0f;  // pixels
};

template <class Distance>
void fill(Image& image, const Vec2& low, const Vec2& high, const Paint& paint, Distance distance) {
    const Vec2 reach = Vec2::Constant(paint.rimWidth + 1.0f);
    const PixelRange range = pixelsWithin(image, low - reach, high + reach);
    for (int y = range.y0; y <= range.y1; ++y)
        for (int x = range.x0; x <= range.x1; ++x) {
            const float d = distance(centreOf(x, y));
            if (d >= paint.rimWidth + 0.5f) continue;
            const float inside = std::clamp(0.5f - d, 0.0f, 1.0f);
            if (paint.rimWidth > 0.0f && inside < 1.0f)
                blend(image.at(x, y), paint.rim, std::clamp(0.5f - d + paint.rimWidth, 0.0f, 1.0f));
            blend(image.at(x, y), paint.color, inside);
        }
}

/// Distance from p to the segment a-b. `along`: the nearest point, from 0 at a to 1 at b.
inline float toSegment(const Vec2& p, const Vec2& a, const Vec2& b, float& along) {
    const Vec2 ab = b - a;
    const float square = ab.squaredNorm();
    along = square > 0.0f ? std::clamp((p - a).dot(ab) / square, 0.0f, 1.0f) : 0.0f;
    return (p - a - along * ab).norm();
}

/// Signed distance to a rectangle with round corners.
inline float toRoundedBox(const Vec2& p, const Vec2& low, const Vec2& high, float radius) {
    const Vec2 half = 0.5f * (high - low) - Vec2::Constant(radius);
    const Vec2 q = (p - 0.5f * (low + high)).cwiseAbs() - half;
    return q.cwiseMax(0.0f).norm() + std::min(q.maxCoeff(), 0.0f) - radius;
}

/// Pixels of a picture for 1 pixel of 1280x720: `look.unit` if set, else by area, so that a tall
/// picture is as legible as a wide one, but limited by the shorter side.
inline float overlayScale(const Look& look, int width, int height) {
    if (look.unit > 0.0f) return look.unit;
    const float w = static_cast<float>(width), h = static_cast<float>(height);
    return std::min({std::sqrt(w * h / (1280.0f * 720.0f)), w / 400.0f, h / 400.0f});
}

}  // namespace render
