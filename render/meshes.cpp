#include "render/meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "render/facet_mesh.h"
#include "render/linear.h"
#include "render/pi.h"
#include "render/shortest_turn.h"
#include "render/unit_meshes.h"

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
    Sorted(const Vec3& eye, float pixelsAMeter) : eye_(eye), pixelsAMeter_(pixelsAMeter) {}

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
    std::map<const SolidMesh*, std::size_t> places_;  // for lookup only: its order does not matter
};

}  // namespace

Instances instancesOf(const Frame& frame, float pixelsAMeter, const std::vector<char>* chosen) {
    const Vec3& eye = frame.camera.from;
    Sorted sorted(eye, pixelsAMeter);
    Instances& result = sorted.result;
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
    for (ByCorners* levels : {&result.balls, &result.cylinders, &result.cones})
        for (std::vector<Instance>& instances : *levels) sort(instances, eye);
    for (Instances::OfMesh& mesh : result.meshes) sort(mesh.instances, eye);
    return std::move(result);
}

/// Coarse: uses the mesh of the level below, if there is one.
void Meshes::Levels::draw(Detail detail, std::optional<Material> only) const {
    for (std::size_t i = 0; i < meshes.size(); ++i)
        meshes[detail == Detail::coarse && i > 0 ? i - 1 : i].draw(instances[i], only);
}

std::bitset<kMaterials> Meshes::Levels::materials() const {
    std::bitset<kMaterials> result;
    for (const InstanceList& list : instances) result |= list.materials();
    return result;
}

Meshes::Meshes() : box_(boxMesh()) {
    for (const int corners : kBarCorners) bars_.meshes.emplace_back(barMesh(corners));
    for (const int corners : kBallCorners) {
        balls_.meshes.emplace_back(ballMesh(corners));
        cylinders_.meshes.emplace_back(cylinderMesh(corners));
        cones_.meshes.emplace_back(coneMesh(corners));
    }
    for (Levels* shape : {&bars_, &balls_, &cylinders_, &cones_})
        shape->instances = std::vector<InstanceList>(shape->meshes.size());
}

void Meshes::set(const Instances& instances) {
    boxes_.set(instances.boxes);
    for (std::size_t i = 0; i < instances.bars.size(); ++i)
        bars_.instances[i].set(instances.bars[i]);
    for (std::size_t i = 0; i < kBallCorners.size(); ++i) {
        balls_.instances[i].set(instances.balls[i]);
        cylinders_.instances[i].set(instances.cylinders[i]);
        cones_.instances[i].set(instances.cones[i]);
    }
    setMeshes(instances.meshes);
    round_ = balls_.materials() | bars_.materials();
    facets_ = cylinders_.materials() | cones_.materials();
    for (const Uploaded& one : meshes_)
        (one.mesh->anyCrisp ? facets_ : round_) |= one.instances.materials();
}

/// Meshes of the last frame are not uploaded again; those this frame does not use are freed.
void Meshes::setMeshes(const std::vector<Instances::OfMesh>& meshes) {
    std::map<const SolidMesh*, Uploaded*> old;
    for (Uploaded& one : meshes_) old[one.mesh.get()] = &one;
    std::vector<Uploaded> now;
    for (const Instances::OfMesh& one : meshes) {
        const auto known = old.find(one.mesh.get());
        if (known != old.end())
            now.push_back(std::move(*known->second));
        else
            now.push_back({one.mesh, InstancedMesh(facetMesh(*one.mesh)), InstanceList()});
        now.back().instances.set(one.instances);
    }
    meshes_ = std::move(now);
}

void Meshes::drawRound(Detail detail, std::optional<Material> only) const {
    balls_.draw(detail, only);
    bars_.draw(detail, only);
    for (const Uploaded& one : meshes_)
        if (!one.mesh->anyCrisp) one.drawn.draw(one.instances, only);
}

void Meshes::drawFacets(GLuint program, Detail detail, std::optional<Material> only) const {
    setUniform(program, "thinnestOfUnit", 1.0f);
    cylinders_.draw(detail, only);
    cones_.draw(detail, only);
    for (const Uploaded& one : meshes_) {
        if (!one.mesh->anyCrisp) continue;
        setUniform(program, "thinnestOfUnit", one.mesh->thinnest);
        one.drawn.draw(one.instances, only);
    }
}

void Meshes::drawWith(GLuint program, const Eigen::Matrix4f& worldToClip, Detail detail,
                      std::optional<Material> only) const {
    glUseProgram(program);
    setUniform(program, "worldToClip", worldToClip);
    glEnable(GL_CULL_FACE);
    drawBoxes(only);
    drawRound(detail, only);
    drawFacets(program, detail, only);
    glDisable(GL_CULL_FACE);
}

}  // namespace render
