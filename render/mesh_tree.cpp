// Ray o + t d, triangle a, a + e, a + f with normal n = e x f, s = o - a:
// t = s . n / D,  u = d . (f x s) / D,  v = d . (s x e) / D,  D = -d . n > 0 from outside;
// products without d are the same for all rays from one point.
#include "render/mesh_tree.h"

#include <algorithm>
#include <numeric>

#include "render/solid_mesh.h"
#include "render/surface_map.h"

namespace render {
namespace {

constexpr int kLeaf = 4;           // triangles
constexpr float kSlack = 1e-5f;    // of a triangle, beyond its edges: no ray passes between two
constexpr int kDeepest = 64;       // stack of nodes; halving 2^31 triangles needs half as many

class Builder {
public:
    Builder(const std::vector<Vec3>& vertices, const MeshTriangles& triangles)
        : vertices_(vertices), triangles_(triangles) {
        tree_.order.resize(triangles.size());
        std::iota(tree_.order.begin(), tree_.order.end(), 0);
        for (const auto& [a, b, c] : triangles)
            middles_.push_back((vertices[a] + vertices[b] + vertices[c]) / 3.0f);
        if (!triangles.empty()) add(0, static_cast<int>(triangles.size()));
    }
    MeshTree tree() { return std::move(tree_); }

private:
    void add(int first, int end) {
        const std::size_t at = tree_.nodes.size();
        tree_.nodes.push_back(boundsOf(first, end));
        if (end - first <= kLeaf) {
            tree_.nodes[at].first = first, tree_.nodes[at].count = end - first;
            return;
        }
        const Vec3 size = tree_.nodes[at].high - tree_.nodes[at].low;
        Eigen::Index axis = 0;
        size.maxCoeff(&axis);
        const auto begin = tree_.order.begin();
        const int half = first + (end - first) / 2;
        std::nth_element(begin + first, begin + half, begin + end, [&](int a, int b) {
            const float x = middles_[a][axis], y = middles_[b][axis];
            return x < y || (x == y && a < b);
        });
        add(first, half);
        tree_.nodes[at].second = static_cast<int>(tree_.nodes.size());
        tree_.nodes[at].axis = static_cast<int>(axis);
        add(half, end);
    }

    MeshTree::Node boundsOf(int first, int end) const {
        MeshTree::Node node;
        node.low.setConstant(kNever), node.high.setConstant(-kNever);
        for (int i = first; i < end; ++i)
            for (const int corner : triangles_[tree_.order[i]]) {
                node.low = node.low.cwiseMin(vertices_[corner]);
                node.high = node.high.cwiseMax(vertices_[corner]);
            }
        return node;
    }

    const std::vector<Vec3>& vertices_;
    const MeshTriangles& triangles_;
    std::vector<Vec3> middles_;  // of the triangles
    MeshTree tree_;
};

bool any(FourInts m) { return (m[0] | m[1] | m[2] | m[3]) != 0; }

class TreeSearch {
public:
    TreeSearch(const SolidMesh& mesh, const FourRays& rays, int facet)
        : mesh_(mesh), rays_(rays), facet_(facet) {
        found_ = {fourOf(kNever), FourInts{} - 1};
        for (int i = 0; i < 3; ++i) {
            const Four d = rays.along[i];
            inverse_[i] = 1.0f / (magnitude(d) < 1e-12f ? fourOf(1e-12f) : d);
        }
    }

    FourTriangles find() {
        int waiting[kDeepest], count = 0;
        if (!mesh_.tree->nodes.empty()) waiting[count++] = 0;
        while (count > 0) {
            const int at = waiting[--count];
            const MeshTree::Node& node = mesh_.tree->nodes[at];
            if (!any(meets(node))) continue;
            for (int i = node.first; i < node.first + node.count; ++i) tryOne(mesh_.tree->order[i]);
            if (node.count > 0) continue;
            const bool forward = rays_.along[node.axis][0] > 0.0f;  // the nearer one is next
            waiting[count++] = forward ? node.second : at + 1;
            waiting[count++] = forward ? at + 1 : node.second;
        }
        return found_;
    }

private:
    FourInts meets(const MeshTree::Node& node) const {
        Four in = fourOf(0.0f), out = found_.t;
        for (int i = 0; i < 3; ++i) {
            const Four low = (node.low[i] - rays_.from[i]) * inverse_[i];
            const Four high = (node.high[i] - rays_.from[i]) * inverse_[i];
            const Four entry = smaller(low, high);
            in = entry > in ? entry : in;
            out = smaller(low > high ? low : high, out);
        }
        return in <= out * (1.0f + 1e-5f);  // a flat box has no inside
    }

    Four along(const Vec3& v) const {
        return rays_.along[0] * v.x() + rays_.along[1] * v.y() + rays_.along[2] * v.z();
    }

    void tryOne(int triangle) {
        if (facet_ >= 0 && (mesh_.facets[triangle] & (kFaces - 1)) != facet_) return;
        const auto& [ia, ib, ic] = mesh_.triangles[triangle];
        const Vec3& a = mesh_.vertices[ia];
        const Vec3 e = mesh_.vertices[ib] - a, f = mesh_.vertices[ic] - a, n = e.cross(f);
        const Vec3 s = rays_.from - a;
        const float above = s.dot(n);
        if (above <= 0.0f) return;
        const Four d = -along(n), u = along(f.cross(s)), v = along(s.cross(e));
        const FourInts inside = (d > 0.0f) & (u >= -kSlack * d) & (v >= -kSlack * d) &
                                (u + v <= (1.0f + kSlack) * d);
        const Four t = above / d;
        const FourInts nearer = inside & (t < found_.t);
        found_.t = nearer ? t : found_.t;
        found_.triangle = nearer ? FourInts{} + triangle : found_.triangle;
    }

    const SolidMesh& mesh_;
    const FourRays& rays_;
    const int facet_;
    Four inverse_[3];
    FourTriangles found_;
};

}  // namespace

MeshTree treeOf(const std::vector<Vec3>& vertices, const MeshTriangles& triangles) {
    return Builder(vertices, triangles).tree();
}

FourTriangles nearestTriangles(const SolidMesh& mesh, const FourRays& rays, int facet) {
    return TreeSearch(mesh, rays, facet).find();
}

}  // namespace render
