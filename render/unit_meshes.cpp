#include "render/unit_meshes.h"

#include <algorithm>
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

namespace {

struct Ring {
    float angle, end;  // above the equator
    int corners;       // 0 at a pole
};

Vertex cornerOf(const Ring& ring, int corner) {
    const float share = ring.corners == 0 ? 0.0f : static_cast<float>(corner % ring.corners) /
                                                       static_cast<float>(ring.corners);
    const float turn = 2 * kPi * share;
    const Vec3 p(std::cos(ring.angle) * std::cos(turn), std::sin(ring.angle),
                 -std::cos(ring.angle) * std::sin(turn));
    return {p, p, ring.end, 0.0f};
}

/// From the equator to the pole above it, `steps` above each other. `corners`: of a ring at an angle.
template <class Corners>
std::vector<Ring> upperRings(int steps, float end, Corners corners) {
    std::vector<Ring> rings;
    for (int i = 0; i < steps; ++i) {
        const float angle = kPi / 2 * static_cast<float>(i) / static_cast<float>(steps);
        rings.push_back({angle, end, corners(angle)});
    }
    rings.push_back({kPi / 2, end, 0});
    return rings;
}

std::vector<Ring> turnedOver(std::vector<Ring> rings) {
    std::reverse(rings.begin(), rings.end());
    for (Ring& ring : rings) ring.angle = -ring.angle, ring.end = -ring.end;
    return rings;
}

/// Triangles between neighbours. Each has a side on one ring; the rings take turns by angle.
void joinRings(const Ring& low, const Ring& high, std::vector<Vertex>& mesh) {
    for (int i = 0, j = 0; i < low.corners || j < high.corners;) {
        const bool onLow = j == high.corners || (i < low.corners && (2 * i + 1) * high.corners <
                                                                        (2 * j + 1) * low.corners);
        const Vertex a = cornerOf(low, i), d = cornerOf(high, j);
        const Vertex next = onLow ? cornerOf(low, ++i) : cornerOf(high, ++j);
        mesh.insert(mesh.end(), {a, next, d});
    }
}

std::vector<Vertex> meshOf(const std::vector<Ring>& rings) {
    std::vector<Vertex> mesh;
    for (std::size_t i = 0; i + 1 < rings.size(); ++i) joinRings(rings[i], rings[i + 1], mesh);
    return mesh;
}

}  // namespace

/// All rings have the same corners, one above the other, so that the outline is round from
/// everywhere. The equator is there twice, once for each end of a capsule.
std::vector<Vertex> ballMesh(int corners) {
    const std::vector<Ring> upper = upperRings(corners / 4, 1.0f, [corners](float) { return corners; });
    std::vector<Ring> rings = turnedOver(upper);
    rings.insert(rings.end(), upper.begin(), upper.end());
    return meshOf(rings);
}

/// Above the rim, triangles are about as wide as high.
std::vector<Vertex> domeMesh(int corners) {
    const int steps = (corners + 5) / 7;
    return meshOf(upperRings(steps, 0.0f, [corners, steps](float angle) {
        const float wanted = std::cos(angle) * static_cast<float>(4 * steps);
        return angle == 0.0f ? corners : std::max(static_cast<int>(std::lround(wanted)), 4);
    }));
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
