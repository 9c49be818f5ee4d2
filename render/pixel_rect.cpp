#include "render/pixel_rect.h"

#include <algorithm>
#include <cmath>

#include "render/solid_mesh.h"

namespace render {
namespace {

constexpr float kEdge = 2.0f;  // pixels: an anti-aliased edge is a little wider

/// Collects projected points.
class Around {
public:
    Around(const View& view, int width, int height) : view_(view), width_(width), height_(height) {}

    void add(const Vec3& point) {
        const Projected p = project(view_, point, width_, height_);
        (p.depth > 0 ? front_ : back_) = true;
        low_ = low_.cwiseMin(Eigen::Vector2f(p.x - kEdge, p.y - kEdge));
        high_ = high_.cwiseMax(Eigen::Vector2f(p.x + kEdge, p.y + kEdge));
    }
    void addBox(const Vec3& middle, const Vec3& u, const Vec3& v, const Vec3& w) {
        for (int corner = 0; corner < 8; ++corner)
            add(middle + (corner & 1 ? u : -u) + (corner & 2 ? v : -v) + (corner & 4 ? w : -w));
    }
    PixelRect rect() const {
        if (!front_) return {};
        if (back_) return {0, 0, width_, height_};
        const auto inside = [](float x, int most) {
            return static_cast<int>(std::clamp(x, 0.0f, static_cast<float>(most)));
        };
        return {inside(std::floor(low_.x()), width_), inside(std::floor(low_.y()), height_),
                inside(std::ceil(high_.x()), width_), inside(std::ceil(high_.y()), height_)};
    }

private:
    const View& view_;
    int width_, height_;
    bool front_ = false, back_ = false;  // of the eye
    Eigen::Vector2f low_{1e9f, 1e9f}, high_{-1e9f, -1e9f};
};

}  // namespace

PixelRect PixelRect::grown(int border, int width, int height) const {
    if (empty()) return *this;
    return {std::max(x0 - border, 0), std::max(y0 - border, 0), std::min(x1 + border, width),
            std::min(y1 + border, height)};
}

PixelRect common(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

std::vector<PixelRect> around(const PixelRect& hole, const PixelRect& all) {
    if (hole.empty()) return {all};
    std::vector<PixelRect> parts;
    for (const PixelRect& part : {PixelRect{all.x0, all.y0, all.x1, hole.y0},
                                  PixelRect{all.x0, hole.y1, all.x1, all.y1},
                                  PixelRect{all.x0, hole.y0, hole.x0, hole.y1},
                                  PixelRect{hole.x1, hole.y0, all.x1, hole.y1}})
        if (!part.empty()) parts.push_back(part);
    return parts;
}

std::vector<PixelRect> bodyRects(const Frame& frame, const View& view, int width, int height) {
    std::vector<PixelRect> rects;
    const auto add = [&rects](const Around& around) {
        if (!around.rect().empty()) rects.push_back(around.rect());
    };
    for (const Solid& s : frame.solids) {
        const Vec3 half = holdingHalfSize(s);
        const Eigen::Matrix3f axes = s.rotation.toRotationMatrix();
        Around around(view, width, height);
        around.addBox(s.position, half.x() * axes.col(0), half.y() * axes.col(1),
                      half.z() * axes.col(2));
        add(around);
    }
    for (const Rod& rod : frame.rods) {
        Around around(view, width, height);
        for (const Vec3& end : {rod.from, rod.to})
            around.addBox(end, rod.radius * Vec3::UnitX(), rod.radius * Vec3::UnitY(),
                          rod.radius * Vec3::UnitZ());
        add(around);
    }
    return rects;
}

PixelRect boundsOf(const std::vector<PixelRect>& rects) {
    if (rects.empty()) return {};
    PixelRect all = rects.front();
    for (const PixelRect& r : rects)
        all = {std::min(all.x0, r.x0), std::min(all.y0, r.y0), std::max(all.x1, r.x1),
               std::max(all.y1, r.y1)};
    return all;
}

}  // namespace render
