#include "engine/shapes/mesh.h"

#include <algorithm>
#include <map>

namespace engine {
namespace {

constexpr int kInLeaf = 2;              // triangles
constexpr double kSharp = 0.999;        // cosine: edges bent by less than 2.6 degrees are flat
constexpr double kStraight = 1e-6;          // sine: edges bent by less are only rounded

bool isBefore(const Vec3& a, const Vec3& b) {
    for (int i = 0; i < 3; ++i)
        if (a[i] != b[i]) return a[i] < b[i];
    return false;
}

/// For each corner, the number of the first corner at the same place.
std::vector<int> weld(std::span<const Vec3> corners) {
    std::map<Vec3, int, bool (*)(const Vec3&, const Vec3&)> places(isBefore);
    std::vector<int> first;
    for (int i = 0; i < static_cast<int>(corners.size()); ++i)
        first.push_back(places.emplace(corners[i], i).first->second);
    return first;
}

/// A directed edge and one of its triangles: from, to, triangle.
using EdgeOfTriangle = std::array<int, 3>;

std::vector<EdgeOfTriangle> sortedEdges(const Mesh& mesh) {
    std::vector<EdgeOfTriangle> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
        for (int i = 0; i < 3; ++i) {
            const std::array<int, 3>& c = mesh.triangles[t].corners;
            edges.push_back({c[i], c[(i + 1) % 3], t});
        }
    std::ranges::sort(edges);
    return edges;
}

void markSharp(Mesh& mesh) {
    const std::vector<EdgeOfTriangle> edges = sortedEdges(mesh);
    for (Mesh::Triangle& triangle : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            const int from = triangle.corners[i], to = triangle.corners[(i + 1) % 3];
            const auto beside = std::ranges::lower_bound(edges, EdgeOfTriangle{to, from, 0});
            triangle.sharp[i] = true;
            if (beside == edges.end() || (*beside)[0] != to || (*beside)[1] != from) continue;
            const Mesh::Triangle& other = mesh.triangles[(*beside)[2]];
            double height = 0.0;  // of the neighbour's third corner
            for (const int c : other.corners)
                if (c != from && c != to)
                    height = triangle.normal.dot(mesh.corners[c] - mesh.corners[from]);
            triangle.sharp[i] = height < 0.0 && triangle.normal.dot(other.normal) < kSharp;
            triangle.slight[i] = height < 0.0 && !triangle.sharp[i] &&
                                 triangle.normal.cross(other.normal).norm() > kStraight;
        }
}

void measure(Mesh::Triangle& triangle, const std::vector<Vec3>& corners) {
    triangle.middle = Vec3::Zero();
    for (const int c : triangle.corners) triangle.middle += corners[c] / 3.0;
    for (const int c : triangle.corners)
        triangle.reach = larger(triangle.reach, (corners[c] - triangle.middle).norm());
}

void findNeighbours(Mesh& mesh) {
    if (std::ranges::none_of(mesh.triangles, &Mesh::Triangle::isAnySlight)) return;
    for (const Mesh::Triangle& triangle : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            const int from = triangle.corners[i], to = triangle.corners[(i + 1) % 3];
            mesh.beside.push_back({from, to});
            mesh.beside.push_back({to, from});
        }
    std::ranges::sort(mesh.beside);
    mesh.beside.erase(std::unique(mesh.beside.begin(), mesh.beside.end()), mesh.beside.end());
    mesh.beside.shrink_to_fit();
}

class TreeBuilder {
public:
    explicit TreeBuilder(Mesh& mesh) : mesh_(mesh) {}

    /// Splits at the median of the centroids along the longest side.
    void build(int first, int end) {
        const int node = static_cast<int>(mesh_.nodes.size());
        mesh_.nodes.push_back({boundsOf(first, end), first, 0, 0});
        if (end - first <= kInLeaf) {
            mesh_.nodes[node].count = end - first;
        } else {
            const Bounds& bounds = mesh_.nodes[node].bounds;
            int axis = 0;
            (bounds.high - bounds.low).maxCoeff(&axis);
            const auto begin = mesh_.triangles.begin();
            std::stable_sort(begin + first, begin + end,
                             [&](const Mesh::Triangle& a, const Mesh::Triangle& b) {
                                 return middle(a, axis) < middle(b, axis);
                             });
            const int half = first + (end - first) / 2;
            build(first, half);
            build(half, end);
        }
        mesh_.nodes[node].next = static_cast<int>(mesh_.nodes.size());
    }

private:
    double middle(const Mesh::Triangle& t, int axis) const {
        double sum = 0.0;
        for (const int c : t.corners) sum += mesh_.corners[c][axis];
        return sum;
    }
    Bounds boundsOf(int first, int end) const {
        const Vec3 start = mesh_.corners[mesh_.triangles[first].corners[0]];
        Bounds bounds{start, start};
        for (int t = first; t < end; ++t)
            for (const int c : mesh_.triangles[t].corners)
                bounds = bounds.with({mesh_.corners[c], mesh_.corners[c]});
        return bounds;
    }

    Mesh& mesh_;
};

}  // namespace

Mesh makeMesh(std::span<const Vec3> corners, std::span<const std::array<int, 3>> triangles) {
    Mesh mesh;
    mesh.corners.assign(corners.begin(), corners.end());
    const std::vector<int> welded = weld(corners);
    for (const std::array<int, 3>& t : triangles) {
        const Vec3 a = corners[t[0]], b = corners[t[1]], c = corners[t[2]];
        const Vec3 area = 0.5 * (b - a).cross(c - a);
        if (area.norm() < kLeastArea) continue;
        Mesh::Triangle& triangle = mesh.triangles.emplace_back();
        triangle.corners = {welded[t[0]], welded[t[1]], welded[t[2]]};
        triangle.normal = area.normalized();
        measure(triangle, mesh.corners);
    }
    if (mesh.triangles.empty()) return mesh;
    markSharp(mesh);
    findNeighbours(mesh);
    TreeBuilder(mesh).build(0, static_cast<int>(mesh.triangles.size()));
    return mesh;
}

}  // namespace engine
