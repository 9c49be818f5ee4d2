#include "demos/mjcf/hulls.h"

#include "engine/base/trigonometry.h"
#include "engine/shapes/mass.h"

namespace demos::mjcf {
namespace {

using engine::Shape;
using engine::Vec3;

constexpr int kDirections = 200;
constexpr int kEllipsoidCorners = 120;

/// Evenly distributed over the sphere: a golden-angle spiral.
std::vector<Vec3> directions(int count) {
    constexpr double kGoldenAngle = 2.39996322972865332;  // rad, pi (3 - sqrt 5)
    std::vector<Vec3> all;
    for (int i = 0; i < count; ++i) {
        const double y = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - y * y);
        const double angle = kGoldenAngle * i;
        all.push_back({r * engine::cosine(angle), y, r * engine::sine(angle)});
    }
    return all;
}

std::vector<Vec3> farthestOut(std::span<const Vec3> points) {
    std::vector<Vec3> chosen;
    for (const Vec3& direction : directions(kDirections)) {
        const Vec3* best = &points.front();
        for (const Vec3& point : points)
            if (direction.dot(point) > direction.dot(*best)) best = &point;
        chosen.push_back(*best);
    }
    return chosen;
}

}  // namespace

std::optional<Shape> hullOfAny(std::span<const Vec3> points) {
    if (points.size() < 4) return std::nullopt;
    if (std::optional<Shape> shape = Shape::hullOf(points)) return shape;
    return Shape::hullOf(farthestOut(points));
}

std::vector<Vec3> ellipsoidCorners(const Vec3& halfAxes) {
    std::vector<Vec3> corners = directions(kEllipsoidCorners);
    // A hull with its corners on the sphere is smaller than the ball.
    const double volume = engine::volume(*Shape::hullOf(corners)), ball = 4.0 / 3.0 * engine::kPi;
    double scale = 1.0;
    for (int i = 0; i < 8; ++i)  // the cube root, by Newton
        scale -= (scale * scale * scale - ball / volume) / (3.0 * scale * scale);
    for (Vec3& corner : corners) corner = scale * corner.cwiseProduct(halfAxes);
    return corners;
}

}  // namespace demos::mjcf
