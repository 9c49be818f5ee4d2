#include "render/meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "render/facet_mesh.h"

namespace render {
namespace {

constexpr float kPi = 3.14159265f;

}  // namespace

std::vector<Vertex> boxMesh() {
    std::vector<Vertex> mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            const Vec3 normal = side * Vec3::Unit(axis);
            const Vec3 u = Vec3::Unit((axis + 1) % 3), v = normal.cross(u);
            const Vec3 corner[4] = {normal - u - v, normal + u - v, normal + u + v, normal - u + v};
            const float face = static_cast<float>(2 * axis) + (side > 0.0f ? 1.0f : 0.0f);
            for (const int i : {0, 1, 2, 0, 2, 3})
                mesh.push_back({corner[i], normal, 0.0f, face});
        }
    return mesh;
}

/// In rings; the equator is there twice, once for either end of a capsule.
std::vector<Vertex> ballMesh(int corners) {
    const int slices = corners, half = corners / 4;
    struct Ring {
        float angle, end;
    };
    std::vector<Ring> rings;
    const float right = kPi / 2, steps = static_cast<float>(half);
    for (int i = 0; i <= half; ++i)
        rings.push_back({right * static_cast<float>(i) / steps - right, -1.0f});
    for (int i = 0; i <= half; ++i) rings.push_back({right * static_cast<float>(i) / steps, 1.0f});
    const auto vertex = [slices](const Ring& ring, int slice) {
        const float share = static_cast<float>(slice % slices) / static_cast<float>(slices);
        const float turn = 2 * kPi * share;
        const Vec3 p(std::cos(ring.angle) * std::cos(turn), std::sin(ring.angle),
                     -std::cos(ring.angle) * std::sin(turn));
        return Vertex{p, p, ring.end, 0.0f};
    };
    std::vector<Vertex> mesh;
    for (std::size_t r = 0; r + 1 < rings.size(); ++r)
        for (int s = 0; s < slices; ++s) {
            const Vertex a = vertex(rings[r], s), b = vertex(rings[r], s + 1);
            const Vertex c = vertex(rings[r + 1], s + 1), d = vertex(rings[r + 1], s);
            mesh.insert(mesh.end(), {a, b, c, a, c, d});
        }
    return mesh;
}

/// A cylinder along y from -1 to 1, open: its ends are hidden in what it holds together.
std::vector<Vertex> barMesh() {
    constexpr int kSlices = 20;
    const auto vertex = [](int slice, float y) {
        const float turn = 2 * kPi * static_cast<float>(slice % kSlices) / kSlices;
        const Vec3 out(std::cos(turn), 0, -std::sin(turn));
        return Vertex{out + Vec3(0, y, 0), out, 0.0f, 0.0f};
    };
    std::vector<Vertex> mesh;
    for (int s = 0; s < kSlices; ++s) {
        const Vertex a = vertex(s, -1), b = vertex(s + 1, -1);
        const Vertex c = vertex(s + 1, 1), d = vertex(s, 1);
        mesh.insert(mesh.end(), {a, b, c, a, c, d});
    }
    return mesh;
}

namespace {

/// Place in kBallCorners: with n corners a circle is off by r (1 - cos(pi / n)).
std::size_t levelOf(float pixels) {
    constexpr float kOff = 0.33f;  // pixels
    std::size_t level = 0;
    while (level + 1 < kBallCorners.size()) {
        const float angle = kPi / static_cast<float>(kBallCorners[level]);
        if (pixels * 0.5f * angle * angle < kOff) break;
        ++level;
    }
    return level;
}

/// Nearest first, by the square of the distance from the eye.
void sortByDistance(std::vector<Instance>& instances, const Vec3& eye) {
    std::stable_sort(instances.begin(), instances.end(), [&](const Instance& a, const Instance& b) {
        return (a.position - eye).squaredNorm() < (b.position - eye).squaredNorm();
    });
}

void addRod(const Rod& rod, float radius, float surface, std::vector<Instance>& bars) {
    const Vec3 along = rod.to - rod.from;
    const float length = along.norm();
    if (length < 1e-6f) return;
    const Quat q = Quat::FromTwoVectors(Vec3::UnitY(), along);
    bars.push_back({0.5f * (rod.from + rod.to), q.coeffs(),
                    {radius, 0.5f * length, radius}, 0.0f, linear(rod.color), surface});
}

}  // namespace

float drawnRadius(const Rod& rod, const Vec3& eye, float pixelsAMeter) {
    constexpr float kThinnest = 0.55f;  // pixels
    const float away = std::max((rod.from - eye).norm(), (rod.to - eye).norm());
    return std::max(rod.radius, kThinnest * away / pixelsAMeter);
}

namespace {

/// Instances of solids, sorted by what they are drawn with.
class Sorted {
public:
    Sorted(const Vec3& eye, float pixelsAMeter) : eye_(eye), pixelsAMeter_(pixelsAMeter) {}

    void add(const Solid& s, float number) {
        Instance one{s.position, s.rotation.normalized().coeffs(), s.halfSize, 0.0f,
                     linear(s.color), number};
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

    Instances result;

private:
    void round(ByCorners& levels, const Instance& one) const {
        const float away = std::max((one.position - eye_).norm(), 1e-3f);
        levels[levelOf(one.scale.x() * pixelsAMeter_ / away)].push_back(one);
    }

    void addMesh(const std::shared_ptr<const SolidMesh>& mesh, Instance one) {
        if (!mesh) return;
        const auto [at, isNew] = places_.insert({mesh.get(), result.meshes.size()});
        if (isNew) result.meshes.push_back({mesh, {}});
        one.scale.setOnes();
        result.meshes[at->second].instances.push_back(one);
    }

    const Vec3 eye_;
    const float pixelsAMeter_;
    std::map<const SolidMesh*, std::size_t> places_;  // looked up only: its order plays no part
};

}  // namespace

Instances instancesOf(const Frame& frame, float pixelsAMeter) {
    const Vec3& eye = frame.camera.from;
    Sorted sorted(eye, pixelsAMeter);
    Instances& result = sorted.result;
    float surface = 0.0f;
    for (const Solid& s : frame.solids) sorted.add(s, surface++);
    for (const Rod& rod : frame.rods)
        addRod(rod, drawnRadius(rod, eye, pixelsAMeter), surface++, result.bars);
    sortByDistance(result.boxes, eye);
    sortByDistance(result.bars, eye);
    for (ByCorners* levels : {&result.balls, &result.cylinders, &result.cones})
        for (std::vector<Instance>& instances : *levels) sortByDistance(instances, eye);
    for (Instances::OfMesh& mesh : result.meshes) sortByDistance(mesh.instances, eye);
    return std::move(result);
}

Meshes::Meshes() : boxes_(boxMesh()), bars_(barMesh()) {
    for (const int corners : kBallCorners) {
        balls_.emplace_back(ballMesh(corners));
        cylinders_.emplace_back(cylinderMesh(corners));
        cones_.emplace_back(coneMesh(corners));
    }
}

void Meshes::set(const Instances& instances) {
    boxes_.setInstances(instances.boxes);
    bars_.setInstances(instances.bars);
    facets_ = false;
    for (const Instances::OfMesh& one : instances.meshes)
        facets_ = facets_ || one.mesh->anyCrisp;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
        balls_[i].setInstances(instances.balls[i]);
        cylinders_[i].setInstances(instances.cylinders[i]);
        cones_[i].setInstances(instances.cones[i]);
        facets_ = facets_ || !instances.cylinders[i].empty() || !instances.cones[i].empty();
    }
    setMeshes(instances.meshes);
}

/// What the last frame had is not sent again; what this one has not is freed.
void Meshes::setMeshes(const std::vector<Instances::OfMesh>& meshes) {
    std::map<const SolidMesh*, Uploaded*> old;
    for (Uploaded& one : meshes_) old[one.mesh.get()] = &one;
    std::vector<Uploaded> now;
    for (const Instances::OfMesh& one : meshes) {
        const auto known = old.find(one.mesh.get());
        if (known != old.end())
            now.push_back(std::move(*known->second));
        else
            now.push_back({one.mesh, InstancedMesh(facetMesh(*one.mesh))});
        now.back().drawn.setInstances(one.instances);
    }
    meshes_ = std::move(now);
}

void Meshes::drawRound() const {
    for (const InstancedMesh& ball : balls_) ball.draw();
    bars_.draw();
    for (const Uploaded& one : meshes_)
        if (!one.mesh->anyCrisp) one.drawn.draw();
}

void Meshes::drawFacets(GLuint program) const {
    setUniform(program, "thinnestOfUnit", 1.0f);
    for (const InstancedMesh& cylinder : cylinders_) cylinder.draw();
    for (const InstancedMesh& cone : cones_) cone.draw();
    for (const Uploaded& one : meshes_) {
        if (!one.mesh->anyCrisp) continue;
        setUniform(program, "thinnestOfUnit", one.mesh->thinnest);
        one.drawn.draw();
    }
}

void Meshes::drawWith(GLuint program, const Eigen::Matrix4f& worldToClip) const {
    glUseProgram(program);
    setUniform(program, "worldToClip", worldToClip);
    glEnable(GL_CULL_FACE);
    drawBoxes();
    drawRound();
    drawFacets(program);
    glDisable(GL_CULL_FACE);
}

}  // namespace render
