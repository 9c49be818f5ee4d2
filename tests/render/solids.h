// Solids of triangles with closed forms, and a scene with one of each kind.
#pragma once
#include <cmath>
#include <utility>

#include "render/palette.h"
#include "render/solid_mesh.h"

namespace render {

/// |x| + |y| + |z| <= r
inline std::shared_ptr<const SolidMesh> octahedron(float r) {
    const std::vector<Vec3> corners{{r, 0, 0},  {-r, 0, 0}, {0, r, 0},
                                    {0, -r, 0}, {0, 0, r},  {0, 0, -r}};
    MeshTriangles triangles;
    for (int i = 0; i < 8; ++i) {
        const int x = i & 1, y = 2 + (i >> 1 & 1), z = 4 + (i >> 2 & 1);
        const bool mirrored = ((i ^ i >> 1 ^ i >> 2) & 1) != 0;
        triangles.push_back(mirrored ? std::array{x, z, y} : std::array{x, y, z});
    }
    return makeMesh(corners, triangles, true);
}

/// Extrudes a flat outline, counter-clockwise seen from +z; `caps`: the triangles of its area.
inline std::shared_ptr<const SolidMesh> prism(const std::vector<Eigen::Vector2f>& outline,
                                              const MeshTriangles& caps, float halfThickness,
                                              bool convex) {
    const int n = static_cast<int>(outline.size());
    std::vector<Vec3> corners;
    for (const float z : {-halfThickness, halfThickness})
        for (const Eigen::Vector2f& p : outline) corners.emplace_back(p.x(), p.y(), z);
    MeshTriangles triangles;
    for (const auto& [a, b, c] : caps) {
        triangles.push_back({a, c, b});
        triangles.push_back({a + n, b + n, c + n});
    }
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        triangles.push_back({i, j, j + n});
        triangles.push_back({i, j + n, i + n});
    }
    return makeMesh(corners, triangles, convex);
}

/// An L, 2 m wide and high: a solid that hides parts of itself.
inline std::shared_ptr<const SolidMesh> angleBar() {
    return prism({{-1, -1}, {1, -1}, {1, -0.4f}, {-0.4f, -0.4f}, {-0.4f, 1}, {-1, 1}},
                 {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, 0.5f, false);
}

/// A hexagon, 2 m across its corners.
inline std::shared_ptr<const SolidMesh> hexagonalNut(float halfThickness) {
    std::vector<Eigen::Vector2f> outline;
    for (int i = 0; i < 6; ++i) {
        const float turn = static_cast<float>(i) * 3.14159265f / 3.0f;
        outline.emplace_back(std::cos(turn), std::sin(turn));
    }
    return prism(outline, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, halfThickness, true);
}

/// y = height(x, z) on a square of `side` m, of cells x cells x 2 triangles.
template <class Height>
std::shared_ptr<const SolidMesh> heightField(float side, int cells, Height height,
                                             MeshEdges edges = MeshEdges::sharp) {
    std::vector<Vec3> corners;
    MeshTriangles triangles;
    const float step = side / static_cast<float>(cells);
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; j <= cells; ++j) {
            const float x = static_cast<float>(i) * step - 0.5f * side;
            const float z = static_cast<float>(j) * step - 0.5f * side;
            corners.emplace_back(x, height(x, z), z);
        }
    const auto at = [cells](int i, int j) { return i * (cells + 1) + j; };
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
            triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
        }
    return makeMesh(corners, triangles, false, edges);
}

inline std::shared_ptr<const SolidMesh> hills(float side, int cells) {
    return heightField(side, cells, [](float x, float z) {
        return 0.35f * std::sin(1.6f * x) * std::cos(1.3f * z + 0.4f) + 0.05f * x;
    });
}

inline Solid solidOf(SolidShape shape, const Vec3& halfSize, const Vec3& at, const Color& color) {
    Solid solid;
    solid.shape = shape, solid.halfSize = halfSize, solid.position = at, solid.color = color;
    return solid;
}

inline Solid solidOf(std::shared_ptr<const SolidMesh> mesh, const Vec3& at, const Color& color) {
    Solid solid = solidOf(SolidShape::mesh, mesh->halfSize, at, color);
    solid.mesh = std::move(mesh);
    return solid;
}

/// Cylinder, cone, polyhedra, angle bar, box and ball on hills.
inline Frame everySolid() {
    Frame frame;
    frame.camera = {{3.2f, 3.8f, 8.4f}, {0.1f, 0.45f, 0}, {0, 1, 0}, 35};
    frame.grounds.push_back({true, {0, 1, 0}, -0.9f, 0});
    const auto add = [&frame](Solid solid, const Vec3& axis, float angle) {
        solid.rotation = Quat(Eigen::AngleAxisf(angle, axis.normalized()));
        frame.solids.push_back(std::move(solid));
    };
    add(solidOf(hills(6, 40), {0, -0.35f, 0}, fromHex(0x9aa08a)), {0, 1, 0}, 0);
    add(solidOf(SolidShape::cylinder, {0.4f, 0.55f, 0.4f}, {-1.9f, 0.9f, 0.6f}, paletteColor(0)),
        {1, 0, 0.4f}, 0.3f);
    add(solidOf(SolidShape::cone, {0.5f, 0.5f, 0.5f}, {-0.7f, 0.75f, 1.1f}, paletteColor(1)),
        {1, 0, 0}, 0.0f);
    add(solidOf(octahedron(0.65f), {0.5f, 1.0f, 0.6f}, paletteColor(2)), {1, 2, 3}, 0.5f);
    add(solidOf(hexagonalNut(0.4f), {1.8f, 0.75f, 0.6f}, paletteColor(3)), {1, 0.1f, 0.3f}, 1.3f);
    add(solidOf(angleBar(), {-0.6f, 1.5f, -1.3f}, paletteColor(4)), {0, 1, 0.2f}, 0.5f);
    add(solidOf(SolidShape::box, {0.4f, 0.4f, 0.4f}, {1.3f, 1.2f, -1.2f}, paletteColor(5)),
        {0, 1, 0}, 0.4f);
    add(solidOf(SolidShape::sphere, {0.4f, 0.4f, 0.4f}, {2.6f, 0.7f, -1.0f}, heavyColor()),
        {0, 1, 0}, 0);
    return frame;
}

}  // namespace render
