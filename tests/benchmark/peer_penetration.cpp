#include "tests/benchmark/peer_penetration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace peers {

namespace {

constexpr double kCell = 2.4;  // m: two small bodies that touch lie in neighbouring cells

/// A box in the form that the separating-axis test needs.
struct Obb {
    Vec3 halfSize, center;
    std::array<Vec3, 3> axes;

    Obb(const Body& body, const Pose& pose) : halfSize(body.halfSize), center(pose.position) {
        for (int i = 0; i < 3; ++i) axes[i] = pose.rotation * Vec3(Vec3::Unit(i));
    }
    /// Half the length of the box's shadow on a unit axis.
    double reachAlong(const Vec3& axis) const {
        double reach = 0.0;
        for (int i = 0; i < 3; ++i) reach += halfSize[i] * std::abs(axes[i].dot(axis));
        return reach;
    }
};

/// Separating axes: the faces' normals and the cross products of the edges (Gottschalk 1996).
std::array<Vec3, 15> axesBetween(const Obb& a, const Obb& b) {
    std::array<Vec3, 15> axes;
    for (int i = 0; i < 3; ++i) {
        axes[i] = a.axes[i];
        axes[3 + i] = b.axes[i];
        for (int k = 0; k < 3; ++k) axes[6 + 3 * i + k] = a.axes[i].cross(b.axes[k]);
    }
    return axes;
}

/// The least overlap of the two shadows over all axes.
double boxInBox(const Obb& a, const Obb& b) {
    const Vec3 between = b.center - a.center;
    double least = 1e9;
    for (const Vec3& axis : axesBetween(a, b)) {
        const double length = axis.norm();
        if (length < 1e-6) continue;  // parallel edges: a face's axis covers this case
        const Vec3 n = axis / length;
        least = std::min(least, a.reachAlong(n) + b.reachAlong(n) - std::abs(between.dot(n)));
        if (least <= 0.0) break;
    }
    return least;
}

/// Centre outside: radius minus distance. Inside: radius plus distance to the nearest face.
double sphereInBox(const Body& box, const Pose& boxPose, const Body& sphere, const Vec3& center) {
    const Vec3 local = boxPose.toLocal(center);
    const Vec3 nearest = local.cwiseMax(-box.halfSize).cwiseMin(box.halfSize);
    const double distance = (local - nearest).norm();
    if (distance > 1e-9) return sphere.radius - distance;
    return sphere.radius + (box.halfSize - local.cwiseAbs()).minCoeff();
}

/// Collects the mean and the worst.
struct Sum {
    Penetration result;
    int pairs = 0;

    void add(double depth) {
        if (depth <= 0.0) return;
        result.worst = std::max(result.worst, depth);
        result.mean += (depth - result.mean) / ++pairs;
    }
};

using Cell = std::array<int, 3>;

Cell cellOf(const Vec3& position) {
    Cell cell;
    for (int i = 0; i < 3; ++i)
        cell[i] = static_cast<int>(std::floor(std::clamp(position[i] / kCell, -1e8, 1e8)));
    return cell;
}

/// The cell itself and the 26 around it.
std::array<Cell, 27> cellsAround(const Cell& cell) {
    std::array<Cell, 27> cells;
    for (int n = 0; n < 27; ++n)
        cells[n] = {cell[0] + n / 9 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n % 3 - 1};
    return cells;
}

}  // namespace

double penetration(const Body& a, const Pose& poseA, const Body& b, const Pose& poseB) {
    const Vec3 between = poseB.position - poseA.position;
    if (between.norm() > a.reach() + b.reach()) return a.reach() + b.reach() - between.norm();
    const bool boxA = a.kind == Kind::box, boxB = b.kind == Kind::box;
    if (boxA && boxB) return boxInBox({a, poseA}, {b, poseB});
    if (boxA) return sphereInBox(a, poseA, b, poseB.position);
    if (boxB) return sphereInBox(b, poseB, a, poseA.position);
    return a.radius + b.radius - between.norm();
}

PenetrationCheck::PenetrationCheck(const Scene& scene) : scene_(scene) {
    for (const Joint& joint : scene.joints) joined_.insert(std::minmax({joint.a, joint.b}));
    for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i)
        if (scene.bodies[i].collide)
            (scene.bodies[i].reach() > kCell / 2 ? large_ : small_).push_back(i);
}

/// Pairs each large body with the other large ones and with all small ones.
std::vector<PenetrationCheck::Pair> PenetrationCheck::pairsOfLarge() const {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < large_.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) pairs.push_back({large_[k], large_[i]});
        for (int small : small_) pairs.push_back({large_[i], small});
    }
    return pairs;
}

std::vector<PenetrationCheck::Pair> PenetrationCheck::pairsOfNeighbours(
    std::span<const BodyState> states) const {
    std::map<Cell, std::vector<int>> grid;
    for (int i : small_) grid[cellOf(states[i].pose.position)].push_back(i);
    std::vector<Pair> pairs;
    for (int i : small_)
        for (const Cell& cell : cellsAround(cellOf(states[i].pose.position))) {
            const auto found = grid.find(cell);
            if (found == grid.end()) continue;
            for (int k : found->second)
                if (k < i) pairs.push_back({k, i});
        }
    return pairs;
}

bool PenetrationCheck::mayMeet(const Pair& pair) const {
    if (!scene_.bodies[pair.first].dynamic && !scene_.bodies[pair.second].dynamic) return false;
    return !joined_.count(std::minmax(pair.first, pair.second));
}

Penetration PenetrationCheck::measure(std::span<const BodyState> states) const {
    std::vector<Pair> pairs = pairsOfNeighbours(states);
    const std::vector<Pair> large = pairsOfLarge();
    pairs.insert(pairs.end(), large.begin(), large.end());
    Sum sum;
    for (const Pair& pair : pairs)
        if (mayMeet(pair))
            sum.add(penetration(scene_.bodies[pair.first], states[pair.first].pose,
                                scene_.bodies[pair.second], states[pair.second].pose));
    return sum.result;
}

}  // namespace peers
