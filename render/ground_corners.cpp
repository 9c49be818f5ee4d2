#include "render/ground_corners.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "render/sight.h"

namespace render {
namespace {

using Quad = std::array<Vec3, 4>;

void addQuad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, std::vector<Vec3>& out) {
    out.insert(out.end(), {a, b, c, a, c, d});
}

/// The same quad, large enough to reach `distance` from `eye` on every side.
Quad grown(const Quad& inner, const Vec3& eye, float distance) {
    const Vec3 middle = 0.25f * (inner[0] + inner[1] + inner[2] + inner[3]);
    float least = 1e9f;  // from the middle to the nearest side
    for (int i = 0; i < 4; ++i) {
        const Vec3 side = inner[(i + 1) % 4] - inner[i];
        least = std::min(least, side.cross(inner[i] - middle).norm() / side.norm());
    }
    const float reach = distance + (eye - middle).norm();
    const float factor = std::max(reach / std::max(least, 1e-3f), 2.0f);
    Quad outer;
    for (int i = 0; i < 4; ++i) outer[i] = middle + factor * (inner[i] - middle);
    return outer;
}

/// Whether a ray from the eye hits the ground between the clip planes, well in front of the far one. It advances by
/// 1 m along the view axis.
bool meets(const Ground& ground, const Vec3& ray, const View& view) {
    const Vec3 n = ground.normal.normalized();
    const float above = n.dot(view.eye) - ground.offset, down = -n.dot(ray);
    if (above * down <= 0.0f) return false;
    const float depth = above / down;
    return depth > view.nearest && depth * ray.norm() < 0.95f * view.farthest;
}

}  // namespace

int rowsOfSky(const Frame& frame, const View& view, int width, int height) {
    const Sight sight = sightOf(view, width, height);
    int rows = height;
    const auto covered = [&](float y) {  // the worst case is at one of the row's ends
        const Vec3 left = sight.ahead + y * sight.down;
        const Vec3 right = left + static_cast<float>(width) * sight.right;
        return std::any_of(frame.grounds.begin(), frame.grounds.end(), [&](const Ground& ground) {
            return ground.visible && meets(ground, left, view) && meets(ground, right, view);
        });
    };
    while (rows > 0 && covered(static_cast<float>(rows - 1))) --rows;
    return rows;
}

GroundCorners groundCorners(const Ground& ground, const View& view,
                            const std::vector<Vec3>& footprint) {
    const Vec3 n = ground.normal.normalized();
    const Vec3 helper = std::abs(n.x()) < 0.9f ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitZ());
    GroundCorners corners;
    corners.along = helper.cross(n).normalized();
    corners.across = n.cross(corners.along);
    if (footprint.size() == 4) {
        const Quad inner = {footprint[0], footprint[1], footprint[2], footprint[3]};
        const Quad outer = grown(inner, view.eye, view.farthest);
        addQuad(inner[0], inner[1], inner[2], inner[3], corners.inside);
        for (int i = 0; i < 4; ++i) {
            const int j = (i + 1) % 4;
            addQuad(outer[i], outer[j], inner[j], inner[i], corners.around);
        }
        return corners;
    }
    const Vec3 below = view.eye - (n.dot(view.eye) - ground.offset) * n;
    const Vec3 u = view.farthest * corners.across, v = view.farthest * corners.along;
    addQuad(below - u - v, below + u - v, below + u + v, below - u + v, corners.around);
    return corners;
}

}  // namespace render
