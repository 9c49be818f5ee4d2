// Qhull finds which points are corners and which corners share a face. Everything computed from them, and the
// order, is done here, so that no bit depends on Qhull's build.
#include "engine/shapes/hull.h"

#include <libqhull_r/qhull_ra.h>

#include <algorithm>
#include <string>

#include "engine/base/trigonometry.h"
#include "engine/shape.h"

namespace engine {
namespace {

constexpr double kFlat = 1e-4;  // of the extent
// Qhull adds the farthest points first. A hull that has so many corners on the way does not end with
// kMostCorners; to find them all may take a minute.
constexpr int kMostOnTheWay = 4 * Shape::kMostCorners;

template <class Distance>
int farthest(std::span<const Vec3> points, Distance distance) {
    int best = 0;
    double most = -1.0;
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
        if (const double d = distance(points[i]); d > most) most = d, best = i;
    return best;
}

using Loops = std::vector<std::vector<int>>;  // the points of each face, unordered

Loops facesByQhull(std::span<const Vec3> points) {
    std::vector<double> coordinates;
    for (const Vec3& p : points) coordinates.insert(coordinates.end(), p.data(), p.data() + 3);
    Loops faces;
    qhT memory;
    qhT* qh = &memory;
    qh_zero(qh, nullptr);
    std::string options = "qhull TA" + std::to_string(kMostOnTheWay);
    const int failed = qh_new_qhull(qh, 3, static_cast<int>(points.size()), coordinates.data(),
                                    False, options.data(), nullptr, nullptr);
    if (failed == 0)
        for (const facetT* face = qh->facet_list; face && face->next; face = face->next) {
            faces.emplace_back();
            for (int i = 0; i < qh_setsize(qh, face->vertices); ++i) {
                const auto* vertex = static_cast<const vertexT*>(face->vertices->e[i].p);
                faces.back().push_back(qh_pointid(qh, vertex->point));
            }
        }
    int curlong = 0, totlong = 0;  // long memory left: none
    qh_freeqhull(qh, !qh_ALL);
    qh_memfreeshort(qh, &curlong, &totlong);
    return faces;
}

/// Sorts the corners counter-clockwise about the outward normal, beginning with the first.
void putInOrder(Hull::Face& face, std::span<const Vec3> corners, const Vec3& inside) {
    Vec3 middle = Vec3::Zero();
    for (const int i : face.corners) middle += corners[i];
    middle /= static_cast<double>(face.corners.size());
    const Vec3 a = corners[face.corners[0]] - middle;
    Vec3 n = Vec3::Zero();  // with the corner that gives the largest cross product
    for (const int i : face.corners)
        if (const Vec3 wide = a.cross(corners[i] - middle); wide.norm() > n.norm()) n = wide;
    if (n.dot(middle - inside) < 0.0) n = -n;
    const Vec3 x = a.normalized(), y = n.cross(a).normalized();
    std::vector<std::pair<double, int>> turns;
    for (const int i : face.corners) {
        const double turn = arctangent(y.dot(corners[i] - middle), x.dot(corners[i] - middle));
        turns.push_back({i == face.corners[0] ? 0.0 : turn < 0.0 ? turn + 2.0 * kPi : turn, i});
    }
    std::sort(turns.begin(), turns.end());
    for (std::size_t i = 0; i < turns.size(); ++i) face.corners[i] = turns[i].second;
}

/// Newell's normal; no corner is outside the plane.
void findPlane(Hull::Face& face, std::span<const Vec3> corners) {
    Vec3 sum = Vec3::Zero();
    const std::size_t count = face.corners.size();
    const Vec3 first = corners[face.corners[0]];
    for (std::size_t i = 0; i < count; ++i)
        sum += (corners[face.corners[i]] - first)
                   .cross(corners[face.corners[(i + 1) % count]] - first);
    face.normal = sum.normalized();
    face.offset = -1e300;
    for (const int i : face.corners) face.offset = larger(face.offset, face.normal.dot(corners[i]));
}

}  // namespace

bool isFlat(std::span<const Vec3> points) {
    const Vec3 a = points[farthest(points, [&](const Vec3& p) { return (p - points[0]).norm(); })];
    const Vec3 b = points[farthest(points, [&](const Vec3& p) { return (p - a).norm(); })];
    const double extent = (b - a).norm();
    if (extent <= 0.0) return true;
    const Vec3 along = (b - a) / extent;
    const auto aside = [&](const Vec3& p) { return (p - a).cross(along).norm(); };
    const Vec3 c = points[farthest(points, aside)];
    if (aside(c) < kFlat * extent) return true;
    const Vec3 across = along.cross(c - a).normalized();
    const auto above = [&](const Vec3& p) { return std::abs(across.dot(p - a)); };
    return above(points[farthest(points, above)]) < kFlat * extent;
}

std::optional<Hull> convexHull(std::span<const Vec3> points) {
    for (const Vec3& p : points)
        if (!p.allFinite()) return std::nullopt;
    if (points.size() < 4 || isFlat(points)) return std::nullopt;
    Loops loops = facesByQhull(points);
    std::vector<int> corners;  // indices of points
    for (const std::vector<int>& loop : loops) corners.insert(corners.end(), loop.begin(), loop.end());
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    if (corners.size() < 4 || corners.size() > Shape::kMostCorners) return std::nullopt;
    Hull hull;
    Vec3 inside = Vec3::Zero();
    for (const int i : corners) {
        hull.corners.push_back(points[i]);
        inside += points[i] / static_cast<double>(corners.size());
    }
    for (std::vector<int>& loop : loops) {
        Hull::Face& face = hull.faces.emplace_back();
        for (const int i : loop)
            face.corners.push_back(static_cast<int>(
                std::lower_bound(corners.begin(), corners.end(), i) - corners.begin()));
        std::sort(face.corners.begin(), face.corners.end());
        putInOrder(face, hull.corners, inside);
        findPlane(face, hull.corners);
    }
    std::sort(hull.faces.begin(), hull.faces.end(), [](const Hull::Face& a, const Hull::Face& b) {
        return a.corners < b.corners;
    });
    return hull;
}

}  // namespace engine
