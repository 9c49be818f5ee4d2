// A facet of a convex mesh is a fan around its middle. Each triangle lies along one edge of the
// facet and also stores the edges before and after it: lines and bevels meet at the corners.
#include "render/facet_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "render/pi.h"
#include "render/surface_map.h"

namespace render {
namespace {

constexpr float kBaseFace = 2.0f, kTopFace = 3.0f, kSideFace = 0.0f;  // faces

Vec3 around(int corner, float share, int corners) {
    const float part = static_cast<float>(corner % corners) + share;
    const float turn = 2.0f * kPi * part / static_cast<float>(corners);
    return {std::cos(turn), 0.0f, -std::sin(turn)};
}

/// One sector of a disc at `height`; `up`: +-y. `side`: the normal beyond the rim, across and along
/// y.
void addDiscPart(std::vector<FacetVertex>& mesh, int corner, int corners, float height,
                 const Vec3& up, const Eigen::Vector2f& side) {
    const auto vertex = [&](float share, float radius) {
        const Vec3 out = around(corner, share, corners);
        const Vec3 beyond = side.x() * out + side.y() * Vec3::UnitY();
        return FacetVertex{radius * out + height * Vec3::UnitY(), up, up.y() > 0 ? kTopFace : kBaseFace,
                           Vec3::Constant(1.0f - radius), {beyond, up, up}, {1, 0}, 1.0f};
    };
    const FacetVertex middle = vertex(0.5f, 0.0f), a = vertex(0.0f, 1.0f), b = vertex(1.0f, 1.0f);
    mesh.insert(mesh.end(), {middle, up.y() > 0 ? a : b, up.y() > 0 ? b : a});
}

FacetVertex coneSide(int corner, float share, int corners, float y) {
    const Vec3 out = around(corner, share, corners), normal = 2.0f * out + Vec3::UnitY();
    const float up = 0.5f * (y + 0.5f);  // 0 at the base, 1 at the tip
    return {(1.0f - up) * out + y * Vec3::UnitY(), normal, kSideFace, Vec3::Constant(up),
            {-Vec3::UnitY(), normal, normal}, {1, 2}, 0.5f};
}

/// A corner of a triangle.
struct TriangleCorner {
    Vec3 position, normal;
};
/// An edge of a triangle: a point, the direction inwards on the face, and the normal beyond it.
struct Edge {
    Vec3 at, inwards, beyond;

    Edge(const Vec3& a, const Vec3& b, const Vec3& normal, const Vec3& beyondIt)
        : at(a), inwards(normal.cross(b - a).normalized()), beyond(beyondIt) {}
    float distance(const Vec3& p) const { return std::max(inwards.dot(p - at), 0.0f); }
};

void addTriangle(std::vector<FacetVertex>& mesh, const TriangleCorner (&corners)[3],
                 const Edge* const (&edges)[3], const bool (&crisp)[3], int facet, float apothem) {
    for (const TriangleCorner& c : corners) {
        FacetVertex v{c.position, c.normal, static_cast<float>(facet & (kFaces - 1)), {}, {},
                      {1, 0}, apothem};
        for (int i = 0; i < 3; ++i) {
            v.toEdges[i] = edges[i]->distance(c.position);
            v.beyond[i] = crisp[i] ? edges[i]->beyond : c.normal;
        }
        mesh.push_back(v);
    }
}

/// Corners of a facet in order, and the facets beyond the edges that begin there (-1: none). Empty
/// if the outline is not a single ring.
struct Outline {
    std::vector<int> corners, beyond;
};

std::vector<Outline> outlinesOf(const SolidMesh& mesh) {
    struct Step {
        int to, beyond;
    };
    std::vector<std::map<int, Step>> steps(static_cast<std::size_t>(mesh.facetCount));
    std::vector<int> edges(static_cast<std::size_t>(mesh.facetCount));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const int facet = mesh.facets[t], other = mesh.beyond[t][i];
            const int beyond = other < 0 ? -1 : mesh.facets[other];
            if (beyond == facet) continue;
            steps[facet][mesh.triangles[t][i]] = {mesh.triangles[t][(i + 1) % 3], beyond};
            ++edges[facet];
        }
    std::vector<Outline> outlines(steps.size());
    for (std::size_t facet = 0; facet < steps.size(); ++facet) {
        Outline& ring = outlines[facet];
        int at = steps[facet].begin()->first;
        for (int i = 0; i < edges[facet]; ++i) {
            const auto step = steps[facet].find(at);
            if (step == steps[facet].end()) break;
            ring.corners.push_back(at), ring.beyond.push_back(step->second.beyond);
            at = step->second.to;
        }
        if (ring.corners.empty() || at != ring.corners.front() ||
            ring.corners.size() != steps[facet].size())
            ring = {};
    }
    return outlines;
}

void addFan(std::vector<FacetVertex>& vertices, const SolidMesh& mesh, int facet,
            const Outline& outline) {
    const Vec3& normal = mesh.planes[facet].normal;
    const std::size_t count = outline.corners.size();
    Vec3 middle = Vec3::Zero();
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3& a = mesh.vertices[outline.corners[i]];
        const Vec3& b = mesh.vertices[outline.corners[(i + 1) % count]];
        const int beyond = outline.beyond[i];
        edges.emplace_back(a, b, normal, beyond < 0 ? normal : mesh.planes[beyond].normal);
        middle += a / static_cast<float>(count);
    }
    float apothem = edges[0].distance(middle);
    for (const Edge& edge : edges) apothem = std::min(apothem, edge.distance(middle));
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        const TriangleCorner corners[3] = {{middle, normal},
                                           {mesh.vertices[outline.corners[i]], normal},
                                           {mesh.vertices[outline.corners[next]], normal}};
        const Edge* const three[3] = {&edges[(i + count - 1) % count], &edges[i], &edges[next]};
        addTriangle(vertices, corners, three, {true, true, true}, facet, apothem);
    }
}

/// For every corner of every triangle: the mean normal of the triangles around it that are not
/// beyond a crease, weighted by area.
class Normals {
public:
    explicit Normals(const SolidMesh& mesh) : mesh_(mesh) {}
    /// Walks from triangle to triangle around the corner, both ways.
    Vec3 at(int triangle, int corner) const {
        constexpr int kMost = 1000;  // triangles: a ring that joins itself elsewhere never closes
        const Vec3& point = mesh_.vertices[corner];
        Vec3 sum = area(triangle);
        for (const int way : {1, 2}) {
            int t = triangle;
            for (int steps = 0; steps < kMost; ++steps) {
                const int edge = edgeAt(t, point, way);
                if (edge < 0 || mesh_.crisp[t][edge]) break;
                t = mesh_.beyond[t][edge];
                if (t < 0 || t == triangle) break;
                sum += area(t);
            }
            if (t == triangle) break;  // once around
        }
        return sum.normalized();
    }

private:
    /// The edge that begins (way 1) or ends (way 2) at the corner.
    int edgeAt(int t, const Vec3& point, int way) const {
        for (int i = 0; i < 3; ++i)
            if (mesh_.vertices[mesh_.triangles[t][i]] == point) return way == 1 ? i : (i + 2) % 3;
        return -1;
    }
    Vec3 area(int t) const {
        const auto& [a, b, c] = mesh_.triangles[t];
        return (mesh_.vertices[b] - mesh_.vertices[a]).cross(mesh_.vertices[c] - mesh_.vertices[a]);
    }

    const SolidMesh& mesh_;
};

}  // namespace

std::vector<FacetVertex> cylinderMesh(int corners) {
    std::vector<FacetVertex> mesh;
    for (int s = 0; s < corners; ++s) {
        const auto vertex = [&](float share, float y) {
            const Vec3 out = around(s, share, corners);
            return FacetVertex{out + y * Vec3::UnitY(), out, kSideFace, Vec3(1 - y, 1 + y, 0),
                               {Vec3::UnitY(), -Vec3::UnitY(), out}, {0, 1}, 1.0f};
        };
        const FacetVertex a = vertex(0, -1), b = vertex(1, -1), c = vertex(1, 1), d = vertex(0, 1);
        mesh.insert(mesh.end(), {a, b, c, a, c, d});
        for (const float end : {-1.0f, 1.0f})
            addDiscPart(mesh, s, corners, end, end * Vec3::UnitY(), {1, 0});
    }
    return mesh;
}

/// Normals change within a triangle at the tip, so the triangles there are small.
std::vector<FacetVertex> coneMesh(int corners) {
    constexpr float kHeights[] = {-0.5f, 0.5f, 1.0f, 1.25f, 1.4f, 1.5f};
    std::vector<FacetVertex> mesh;
    for (int s = 0; s < corners; ++s) {
        for (int ring = 0; ring < 4; ++ring) {
            const FacetVertex a = coneSide(s, 0, corners, kHeights[ring]);
            const FacetVertex b = coneSide(s, 1, corners, kHeights[ring]);
            const FacetVertex c = coneSide(s, 1, corners, kHeights[ring + 1]);
            const FacetVertex d = coneSide(s, 0, corners, kHeights[ring + 1]);
            mesh.insert(mesh.end(), {a, b, c, a, c, d});
        }
        mesh.insert(mesh.end(),
                    {coneSide(s, 0, corners, kHeights[4]), coneSide(s, 1, corners, kHeights[4]),
                     coneSide(s, 0.5f, corners, kHeights[5])});
        addDiscPart(mesh, s, corners, -0.5f, -Vec3::UnitY(), {2, 1});
    }
    return mesh;
}

std::vector<FacetVertex> facetMesh(const SolidMesh& mesh) {
    std::vector<FacetVertex> vertices;
    std::vector<bool> fanned(static_cast<std::size_t>(mesh.facetCount), false);
    if (!mesh.planes.empty()) {
        const std::vector<Outline> outlines = outlinesOf(mesh);
        for (std::size_t facet = 0; facet < outlines.size(); ++facet) {
            if (outlines[facet].corners.empty()) continue;
            addFan(vertices, mesh, static_cast<int>(facet), outlines[facet]);
            fanned[facet] = true;
        }
    }
    const Normals normals(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (fanned[mesh.facets[t]]) continue;
        TriangleCorner corners[3];
        for (int i = 0; i < 3; ++i) {
            const int corner = mesh.triangles[t][i];
            corners[i] = {mesh.vertices[corner], normals.at(static_cast<int>(t), corner)};
        }
        const auto edge = [&](int i) {
            const int other = mesh.beyond[t][i];
            return Edge(corners[i].position, corners[(i + 1) % 3].position, mesh.normals[t],
                        other < 0 ? mesh.normals[t] : mesh.normals[other]);
        };
        const Edge edges[3] = {edge(0), edge(1), edge(2)};
        const Edge* const three[3] = {&edges[0], &edges[1], &edges[2]};
        const auto& crisp = mesh.crisp[t];
        const float apothem = edges[0].distance(corners[2].position) / 3.0f;
        addTriangle(vertices, corners, three, {crisp[0], crisp[1], crisp[2]}, mesh.facets[t],
                    apothem);
    }
    return vertices;
}

}  // namespace render
