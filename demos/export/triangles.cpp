#include "demos/export/triangles.h"

#include <array>
#include <cmath>
#include <map>

#include "render/facet_mesh.h"
#include "render/unit_meshes.h"

namespace demos {
namespace {

using render::SolidShape;

constexpr int kCornersAround = 32;  // of round shapes: off by 0.5 % of the radius

/// Gives equal vertices the same number and leaves out triangles that became a line.
class Welding {
public:
    void add(const std::array<render::Vec3, 3>& positions,
             const std::array<render::Vec3, 3>& normals) {
        std::array<std::uint32_t, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i] = numberOf(positions[i], normals[i]);
        if (samePlace(corners[0], corners[1]) || samePlace(corners[1], corners[2]) ||
            samePlace(corners[2], corners[0]))
            return;
        welded_.corners.insert(welded_.corners.end(), corners.begin(), corners.end());
    }
    Triangles take() { return std::move(welded_); }

private:
    std::uint32_t numberOf(const render::Vec3& p, const render::Vec3& n) {
        const std::array key{p.x(), p.y(), p.z(), n.x(), n.y(), n.z()};
        const auto next = static_cast<std::uint32_t>(places_.size());
        const auto [place, isNew] = places_.try_emplace(key, next);
        if (isNew) {
            welded_.positions.insert(welded_.positions.end(), key.begin(), key.begin() + 3);
            welded_.normals.insert(welded_.normals.end(), key.begin() + 3, key.end());
        }
        return place->second;
    }
    bool samePlace(std::uint32_t a, std::uint32_t b) const {
        const float* p = welded_.positions.data();
        return p[3 * a] == p[3 * b] && p[3 * a + 1] == p[3 * b + 1] && p[3 * a + 2] == p[3 * b + 2];
    }

    std::map<std::array<float, 6>, std::uint32_t> places_;
    Triangles welded_;
};

/// Rounding errors of 0, at a pole or across an axis, become 0.
render::Vec3 cleaned(const render::Vec3& v) {
    constexpr float kRounding = 1e-6f;  // of a unit shape
    return v.unaryExpr([](float x) { return std::abs(x) < kRounding ? 0.0f : x; });
}

/// Adds a triangle; its own normal replaces missing normals of vertices.
void addTriangle(const std::array<render::Vec3, 3>& positions, std::array<render::Vec3, 3> normals,
                 Welding& welding) {
    const render::Vec3 own =
        (positions[1] - positions[0]).cross(positions[2] - positions[0]).normalized();
    for (render::Vec3& normal : normals) normal = normal.norm() > 0.0f ? normal.normalized() : own;
    welding.add(positions, normals);
}

/// `place`: of a vertex.
template <class Vertex, class Place>
Triangles welded(const std::vector<Vertex>& vertices, Place place) {
    Welding welding;
    for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
        const Vertex &a = vertices[i], &b = vertices[i + 1], &c = vertices[i + 2];
        addTriangle({place(a), place(b), place(c)}, {a.normal, b.normal, c.normal}, welding);
    }
    return welding.take();
}

template <class Vertex>
Triangles unitTriangles(std::vector<Vertex> vertices) {
    for (Vertex& vertex : vertices) vertex.normal = cleaned(vertex.normal);
    return welded(vertices, [](const Vertex& vertex) { return cleaned(vertex.position); });
}

Triangles capsuleTriangles(float radius, float half) {
    std::vector<render::Vertex> vertices = render::ballMesh(kCornersAround);
    for (render::Vertex& vertex : vertices) vertex.normal = cleaned(vertex.normal);
    return welded(vertices, [&](const render::Vertex& vertex) {
        return render::Vec3(radius * cleaned(vertex.position) +
                            vertex.end * half * render::Vec3::UnitY());
    });
}

}  // namespace

Triangles trianglesOf(const render::Solid& solid) {
    switch (solid.shape) {
        case SolidShape::sphere:
            return unitTriangles(render::ballMesh(kCornersAround));
        case SolidShape::cylinder:
            return unitTriangles(render::cylinderMesh(kCornersAround));
        case SolidShape::cone:
            return unitTriangles(render::coneMesh(kCornersAround));
        case SolidShape::capsule:
            return capsuleTriangles(solid.halfSize.x(), solid.halfSize.y());
        case SolidShape::mesh:
            return welded(render::facetMesh(*solid.mesh),
                          [](const render::FacetVertex& vertex) { return vertex.position; });
        case SolidShape::box:
            break;
    }
    return unitTriangles(render::boxMesh());
}

render::Vec3 scaleOf(const render::Solid& solid) {
    if (solid.shape == SolidShape::capsule || solid.shape == SolidShape::mesh)
        return render::Vec3::Ones();
    return solid.halfSize;
}

Triangles squareTriangles() {
    Welding welding;
    const render::Vec3 a(-1, 0, -1), b(-1, 0, 1), c(1, 0, 1), d(1, 0, -1),
        up = render::Vec3::UnitY();
    welding.add({a, b, c}, {up, up, up});
    welding.add({a, c, d}, {up, up, up});
    return welding.take();
}

}  // namespace demos
