#include "render/unit_meshes.h"

#include <cmath>

#include "render/pi.h"

namespace render {

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

/// Made of rings; the equator is there twice, once for each end of a capsule.
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

/// A cylinder along y from -1 to 1 with open ends: the bodies it connects hide them.
std::vector<Vertex> barMesh(int corners) {
    const auto vertex = [corners](int slice, float y) {
        const float share = static_cast<float>(slice % corners) / static_cast<float>(corners);
        const float turn = 2 * kPi * share;
        const Vec3 out(std::cos(turn), 0, -std::sin(turn));
        return Vertex{out + Vec3(0, y, 0), out, 0.0f, 0.0f};
    };
    std::vector<Vertex> mesh;
    for (int s = 0; s < corners; ++s) {
        const Vertex a = vertex(s, -1), b = vertex(s + 1, -1);
        const Vertex c = vertex(s + 1, 1), d = vertex(s, 1);
        mesh.insert(mesh.end(), {a, b, c, a, c, d});
    }
    return mesh;
}

}  // namespace render
