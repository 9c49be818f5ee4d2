/// A dynamic tree of bounds: leaves are bodies, and every inner node bounds its two children. A leaf is
/// inserted where it enlarges the tree's surface least, and neighbours are swapped on the way up when that
/// makes it smaller. Inserting, removing and querying are logarithmic in the number of bodies. (Goldsmith and
/// Salmon 1987; Kopta et al. 2012; Catto, GDC 2019.)
#pragma once
#include <vector>

#include "engine/shapes/bounds.h"

namespace engine {

class BoundsTree {
public:
    /// Returns the number of the leaf, valid until it is removed.
    int insert(const Bounds& bounds, int body);
    void remove(int leaf);
    const Bounds& bounds(int leaf) const { return nodes_[leaf].bounds; }

    /// Calls visit(body) for every leaf that overlaps, in an order that depends only on the tree. `open` is
    /// the caller's memory for nodes still to visit: one per thread.
    template <class Visit>
    void query(const Bounds& bounds, std::vector<int>& open, Visit visit) const {
        if (root_ < 0) return;
        open.clear();
        open.push_back(root_);
        while (!open.empty()) {
            const Node& node = nodes_[open.back()];
            open.pop_back();
            if (!node.bounds.overlaps(bounds)) continue;
            if (node.isLeaf()) {
                visit(node.body);
            } else {
                open.push_back(node.children[0]);
                open.push_back(node.children[1]);
            }
        }
    }

    /// Calls visit(body) for every leaf that the ray from `from` to `to` (m) hits before its fraction `most`;
    /// visit returns the new `most`.
    template <class Visit>
    void along(const Vec3& from, const Vec3& to, double most, Visit visit) const {
        if (root_ < 0) return;
        const Vec3 way = to - from;
        std::vector<int> open{root_};
        while (!open.empty()) {
            const Node& node = nodes_[open.back()];
            open.pop_back();
            if (!node.bounds.meets(from, way, most)) continue;
            if (node.isLeaf()) {
                most = visit(node.body);
            } else {
                open.push_back(node.children[0]);
                open.push_back(node.children[1]);
            }
        }
    }

    /// Levels below the root; 0 for a single leaf.
    int height() const;
    /// True when every node bounds its children and they refer to it as their parent (for tests).
    bool isConsistent() const;

private:
    struct Node {
        Bounds bounds;
        int parent = -1;
        int children[2] = {-1, -1};
        int body = -1;
        bool isLeaf() const { return children[0] < 0; }
    };

    int newNode();
    int bestSibling(const Bounds& bounds) const;
    void refitFrom(int node);
    void rotate(int node);
    void swapNodes(int parentA, int sideA, int parentB, int sideB);
    int sideOf(int node) const { return nodes_[nodes_[node].parent].children[0] == node ? 0 : 1; }

    std::vector<Node> nodes_;
    std::vector<int> free_;
    int root_ = -1;
};

}  // namespace engine
