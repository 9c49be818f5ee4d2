#include "render/pixel_rect.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr float kEdge = 2.0f;  // pixels: a smoothed edge reaches a little beyond itself

/// Collects projected points.
class Around {
public:
    Around(const View& view, int width, int height) : view_(view), width_(width), height_(height) {}

    void add(const Vec3& point, float pixels = 0.0f) {
        const Projected p = project(view_, point, width_, height_);
        if (p.depth <= 0) whole_ = true;
        const float border = kEdge + pixels;
        low_ = low_.cwiseMin(Eigen::Vector2f(p.x - border, p.y - border));
        high_ = high_.cwiseMax(Eigen::Vector2f(p.x + border, p.y + border));
    }
    void addBox(const Vec3& middle, const Vec3& u, const Vec3& v, const Vec3& w) {
        for (int corner = 0; corner < 8; ++corner)
            add(middle + (corner & 1 ? u : -u) + (corner & 2 ? v : -v) + (corner & 4 ? w : -w));
    }
    PixelRect rect() const {
        if (whole_) return {0, 0, width_, height_};
        const auto inside = [](float x, int most) {
            return static_cast<int>(std::clamp(x, 0.0f, static_cast<float>(most)));
        };
        return {inside(std::floor(low_.x()), width_), inside(std::floor(low_.y()), height_),
                inside(std::ceil(high_.x()), width_), inside(std::ceil(high_.y()), height_)};
    }

private:
    const View& view_;
    int width_, height_;
    bool whole_ = false;
    Eigen::Vector2f low_{1e9f, 1e9f}, high_{-1e9f, -1e9f};
};

}  // namespace

PixelRect PixelRect::grown(int border, int width, int height) const {
    if (empty()) return *this;
    return {std::max(x0 - border, 0), std::max(y0 - border, 0), std::min(x1 + border, width),
            std::min(y1 + border, height)};
}

PixelRect bodiesRect(const Frame& frame, const View& view, int width, int height) {
    Around around(view, width, height);
    for (const Solid& s : frame.solids) {
        Vec3 half = s.halfSize;
        if (s.shape == SolidShape::capsule) half.y() += half.x();
        const Eigen::Matrix3f axes = s.rotation.toRotationMatrix();
        around.addBox(s.position, half.x() * axes.col(0), half.y() * axes.col(1),
                      half.z() * axes.col(2));
    }
    for (const Rod& rod : frame.rods)
        for (const Vec3& end : {rod.from, rod.to})
            around.addBox(end, rod.radius * Vec3::UnitX(), rod.radius * Vec3::UnitY(),
                          rod.radius * Vec3::UnitZ());
    for (const Trail& trail : frame.trails)
        for (const Vec3& point : trail.points)
            around.add(point, trail.pixels * static_cast<float>(height) / 720.0f);
    return around.rect();
}

}  // namespace render
