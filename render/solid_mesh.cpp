// A facet starts with one triangle and grows across edges that are not crisp, to triangles whose
// normals are near the first one's. So no part of a facet hides another part of it; only different
// facets can hide each other.
#include "render/solid_mesh.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <numeric>
#include <utility>

#include "render/error.h"
#include "render/mesh_tree.h"

namespace render {
namespace {

constexpr float kFlat = 0.99996f;         // cosine of half a degree
constexpr float kSharp = 0.8660254f;      // of 30 degrees
constexpr float kOneFacet = 0.9781476f;   // of 12 degrees
constexpr int kMostPlanes = 128;          // of a convex mesh: with more, the tree is faster

float creaseOf(MeshEdges edges) {
    return edges == MeshEdges::all ? kFlat : edges == MeshEdges::sharp ? kSharp : -2.0f;
}

void check(const std::vector<Vec3>& vertices, const MeshTriangles& triangles) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (!vertices[i].allFinite())
            throw Error("vertex " + std::to_string(i) + " of a mesh is not finite");
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (const int corner : triangles[i])
            if (corner < 0 || corner >= static_cast<int>(vertices.size()))
                throw Error("triangle " + std::to_string(i) + " of a mesh refers to vertex " +
                            std::to_string(corner) + " of " + std::to_string(vertices.size()));
}

Vec3 areaOf(const SolidMesh& mesh, const std::array<int, 3>& t) {
    const Vec3& a = mesh.vertices[t[0]];
    return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
}

void dropEmpty(SolidMesh& mesh) {
    std::erase_if(mesh.triangles, [&mesh](const std::array<int, 3>& t) {
        const Vec3& a = mesh.vertices[t[0]];
        const float sides = (mesh.vertices[t[1]] - a).squaredNorm() +
                            (mesh.vertices[t[2]] - a).squaredNorm();
        return !(areaOf(mesh, t).norm() > 1e-6f * sides);
    });
    if (mesh.triangles.empty()) throw Error("a mesh needs a triangle with an area");
}

/// For every vertex: the first one at the same position.
std::vector<int> welded(const std::vector<Vec3>& vertices) {
    std::vector<int> order(vertices.size()), first(vertices.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&vertices](int i) {
        return std::array{vertices[i].x(), vertices[i].y(), vertices[i].z(),
                          static_cast<float>(i)};
    };
    std::sort(order.begin(), order.end(), [&key](int a, int b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    return first;
}

/// Edge i of triangle t, by its two vertices; equal edges in the order of triangles.
struct EdgeOfTriangle {
    int low, high, t, i;
    bool isUp;  // from low to high
    auto operator<=>(const EdgeOfTriangle&) const = default;
};

std::vector<EdgeOfTriangle> sortedEdges(const SolidMesh& mesh) {
    const std::vector<int> same = welded(mesh.vertices);
    std::vector<EdgeOfTriangle> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
        for (int i = 0; i < 3; ++i) {
            const int a = same[mesh.triangles[t][i]], b = same[mesh.triangles[t][(i + 1) % 3]];
            edges.push_back({std::min(a, b), std::max(a, b), t, i, a < b});
        }
    std::sort(edges.begin(), edges.end());
    return edges;
}

/// An edge shared by more than two triangles joins the first two that pass it in opposite directions.
void findNeighbors(SolidMesh& mesh) {
    mesh.beyond.assign(mesh.triangles.size(), {-1, -1, -1});
    const EdgeOfTriangle *up = nullptr, *down = nullptr, *last = nullptr;  // open ones of one edge
    const std::vector<EdgeOfTriangle> edges = sortedEdges(mesh);
    for (const EdgeOfTriangle& edge : edges) {
        if (!last || edge.low != last->low || edge.high != last->high) up = down = nullptr;
        last = &edge;
        const EdgeOfTriangle*& other = edge.isUp ? down : up;
        const EdgeOfTriangle*& own = edge.isUp ? up : down;
        if (!other) {
            if (!own) own = &edge;
            continue;
        }
        mesh.beyond[edge.t][edge.i] = other->t;
        mesh.beyond[other->t][other->i] = edge.t;
        other = nullptr;
    }
}

void findCreases(SolidMesh& mesh, float crease) {
    mesh.crisp.assign(mesh.triangles.size(), {false, false, false});
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const int other = mesh.beyond[t][i];
            mesh.crisp[t][i] = other >= 0 && mesh.normals[t].dot(mesh.normals[other]) < crease;
            mesh.anyCrisp = mesh.anyCrisp || mesh.crisp[t][i];
        }
}

void findFacets(SolidMesh& mesh, float bend) {
    mesh.facets.assign(mesh.triangles.size(), -1);
    std::vector<int> waiting;
    for (std::size_t seed = 0; seed < mesh.triangles.size(); ++seed) {
        if (mesh.facets[seed] >= 0) continue;
        mesh.facets[seed] = mesh.facetCount;
        waiting.assign(1, static_cast<int>(seed));
        for (std::size_t next = 0; next < waiting.size(); ++next)
            for (int i = 0; i < 3; ++i) {
                const int other = mesh.beyond[waiting[next]][i];
                if (other < 0 || mesh.crisp[waiting[next]][i] || mesh.facets[other] >= 0 ||
                    mesh.normals[other].dot(mesh.normals[seed]) < bend)
                    continue;
                mesh.facets[other] = mesh.facetCount;
                waiting.push_back(other);
            }
        ++mesh.facetCount;
    }
}

/// Each plane has the mean normal of its facet and goes through the facet's outermost corner.
void findPlanes(SolidMesh& mesh) {
    std::vector<Vec3> area(static_cast<std::size_t>(mesh.facetCount), Vec3::Zero());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        area[mesh.facets[t]] += areaOf(mesh, mesh.triangles[t]);
    for (const Vec3& a : area) mesh.planes.push_back({a.normalized(), -1e30f});
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        MeshPlane& plane = mesh.planes[mesh.facets[t]];
        for (const int corner : mesh.triangles[t])
            plane.offset = std::max(plane.offset, plane.normal.dot(mesh.vertices[corner]));
    }
}

void findBounds(SolidMesh& mesh) {
    Vec3 low = mesh.vertices[mesh.triangles[0][0]], high = low;
    for (const std::array<int, 3>& t : mesh.triangles)
        for (const int corner : t) {
            low = low.cwiseMin(mesh.vertices[corner]);
            high = high.cwiseMax(mesh.vertices[corner]);
        }
    mesh.halfSize = low.cwiseAbs().cwiseMax(high.cwiseAbs());
    mesh.thinnest = 0.5f * (high - low).minCoeff();
}

}  // namespace

std::shared_ptr<const SolidMesh> makeMesh(std::vector<Vec3> vertices, MeshTriangles triangles,
                                          bool convex, MeshEdges edges) {
    check(vertices, triangles);
    const auto mesh = std::make_shared<SolidMesh>();
    mesh->vertices = std::move(vertices), mesh->triangles = std::move(triangles);
    mesh->convex = convex;
    dropEmpty(*mesh);
    for (const std::array<int, 3>& t : mesh->triangles)
        mesh->normals.push_back(areaOf(*mesh, t).normalized());
    findNeighbors(*mesh);
    findCreases(*mesh, creaseOf(edges));
    findFacets(*mesh, edges == MeshEdges::all ? kFlat : kOneFacet);
    if (convex && edges == MeshEdges::all && mesh->facetCount <= kMostPlanes) findPlanes(*mesh);
    findBounds(*mesh);
    mesh->tree = std::make_shared<MeshTree>(treeOf(mesh->vertices, mesh->triangles));
    return mesh;
}

std::shared_ptr<const SolidMesh> makeMesh(std::vector<Vec3> vertices, MeshTriangles triangles,
                                          bool convex) {
    return makeMesh(std::move(vertices), std::move(triangles), convex,
                    convex ? MeshEdges::all : MeshEdges::sharp);
}

Vec3 holdingHalfSize(const Solid& solid) {
    Vec3 half = solid.halfSize;
    if (solid.shape == SolidShape::capsule) half.y() += half.x();
    if (solid.shape == SolidShape::cone) half.y() *= 1.5f;
    if (solid.shape == SolidShape::mesh) half = solid.mesh ? solid.mesh->halfSize : Vec3::Zero();
    return half;
}

}  // namespace render
