#include "render/instances.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "render/linear.h"
#include "render/pi.h"
#include "render/shortest_turn.h"

namespace render {
namespace {

/// Index in `corners` for a radius in pixels: a circle of n corners is off by r (1 - cos(pi / n)).
template <std::size_t Count>
std::size_t levelOf(float pixels, const std::array<int, Count>& corners) {
    constexpr float kOff = 0.33f;  // pixels
    std::size_t level = 0;
    while (level + 1 < Count) {
        const float angle = kPi / static_cast<float>(corners[level]);
        if (pixels * 0.5f * angle * angle < kOff) break;
        ++level;
    }
    return level;
}

/// By material, then nearest first, so that what is hidden is not shaded; glass farthest first.
void sort(std::vector<Instance>& instances, const Vec3& eye) {
    std::stable_sort(instances.begin(), instances.end(), [&](const Instance& a, const Instance& b) {
        if (a.material != b.material) return a.material < b.material;
        const float awayA = (a.position - eye).squaredNorm();
        const float awayB = (b.position - eye).squaredNorm();
        return a.material == Material::glass ? awayA > awayB : awayA < awayB;
    });
}

Instance barOf(const Rod& rod, float radius, float surface) {
    const Vec3 along = rod.to - rod.from;
    const float length = along.norm();
    const Quat q = shortestTurn<float>(Vec3::UnitY(), along);
    return {0.5f * (rod.from + rod.to), q.coeffs(), {radius, 0.5f * length, radius}, 0.0f,
            linear(rod.color), surface, Material::plastic};
}

}  // namespace

float drawnRadius(const Rod& rod, const Vec3& eye, float pixelsAMeter) {
    constexpr float kThinnest = 0.55f;  // pixels
    const float away = std::max((rod.from - eye).norm(), (rod.to - eye).norm());
    return std::max(rod.radius, kThinnest * away / pixelsAMeter);
}

namespace {

/// Instances of solids and rods, grouped by the mesh they are drawn with.
class Sorted {
public:
    Sorted(const Frame& frame, float pixelsAMeter)
        : eye_(frame.camera.from),
          pixelsAMeter_(pixelsAMeter),
          mirrored_(frame.look.reflection > 0.0f) {}

    void add(const Solid& s, float number) {
        Instance one{s.position, s.rotation.normalized().coeffs(), s.halfSize, 0.0f,
                     linear(s.color), number, s.material};
        switch (s.shape) {
            case SolidShape::box: result.boxes.push_back(one); return;
            case SolidShape::cylinder: round(result.cylinders, one); return;
            case SolidShape::cone: round(result.cones, one); return;
            case SolidShape::mesh: addMesh(s.mesh, one); return;
            case SolidShape::capsule: one.stretch = s.halfSize.y(); break;
            case SolidShape::sphere: break;
        }
        one.scale.setConstant(s.halfSize.x());
        if (s.shape == SolidShape::sphere && showsHalf(one)) {
            one.rotation = shortestTurn<float>(Vec3::UnitY(), eye_ - one.position).coeffs();
            return round(result.domes, one);
        }
        round(result.balls, one);
    }

    void add(const Rod& rod, float number) {
        if ((rod.to - rod.from).norm() < 1e-6f) return;
        const Instance one = barOf(rod, drawnRadius(rod, eye_, pixelsAMeter_), number);
        const float away = std::min((rod.from - eye_).norm(), (rod.to - eye_).norm());
        const float pixels = one.scale.x() * pixelsAMeter_ / std::max(away, 1e-3f);
        result.bars[levelOf(pixels, kBarCorners)].push_back(one);
    }

    /// Keeps the mesh of a body that is not drawn now for later.
    void keepMesh(const Solid& s) {
        if (s.shape == SolidShape::mesh && s.mesh) placeOf(s.mesh);
    }
    void keepMesh(const Rod&) {}

    Instances result;

private:
    /// Whether the half towards the eye can be drawn for the whole ball: without a pattern, which
    /// turns with it, or an image in the floor, which shows another half. A near eye sees less than
    /// half: then the rim is inside the true outline, by a tenth of a pixel at most.
    bool showsHalf(const Instance& ball) const {
        constexpr float kOff = 0.1f;  // pixels: r / sqrt(1 - q^2) - r, q = radius / distance
        const float away = std::max((ball.position - eye_).norm(), 1e-3f);
        const float q = ball.scale.x() / away;
        return !mirrored_ && ball.material == Material::plastic &&
               0.5f * q * q * q * pixelsAMeter_ < kOff;
    }

    void round(ByCorners& levels, const Instance& one) const {
        const float away = std::max((one.position - eye_).norm(), 1e-3f);
        levels[levelOf(one.scale.x() * pixelsAMeter_ / away, kBallCorners)].push_back(one);
    }

    void addMesh(const std::shared_ptr<const SolidMesh>& mesh, Instance one) {
        if (!mesh) return;
        one.scale.setOnes();
        result.meshes[placeOf(mesh)].instances.push_back(one);
    }

    std::size_t placeOf(const std::shared_ptr<const SolidMesh>& mesh) {
        const auto [at, isNew] = places_.insert({mesh.get(), result.meshes.size()});
        if (isNew) result.meshes.push_back({mesh, {}});
        return at->second;
    }

    const Vec3 eye_;
    const float pixelsAMeter_;
    const bool mirrored_;
    std::map<const SolidMesh*, std::size_t> places_;  // for lookup only: its order does not matter
};

}  // namespace

Instances instancesOf(const Frame& frame, float pixelsAMeter, const Vec3& toSun,
                      const std::vector<char>* chosen) {
    const Vec3& eye = frame.camera.from;
    Sorted sorted(frame, pixelsAMeter);
    Instances& result = sorted.result;
    result.towardsSun = shortestTurn<float>(Vec3::UnitY(), toSun).coeffs();
    std::size_t surface = 0;
    const auto add = [&](const auto& body) {
        if (!chosen || (*chosen)[surface])
            sorted.add(body, static_cast<float>(surface));
        else
            sorted.keepMesh(body);
        ++surface;
    };
    for (const Solid& s : frame.solids) add(s);
    for (const Rod& rod : frame.rods) add(rod);
    sort(result.boxes, eye);
    for (std::vector<Instance>& bars : result.bars) sort(bars, eye);
    for (ByCorners* levels : {&result.balls, &result.cylinders, &result.cones, &result.domes})
        for (std::vector<Instance>& instances : *levels) sort(instances, eye);
    for (Instances::OfMesh& mesh : result.meshes) sort(mesh.instances, eye);
    return std::move(result);
}

}  // namespace render
