/// A surface of triangles, with a static tree of bounds.
#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/bounds.h"

namespace engine {

constexpr double kLeastArea = 1e-12;  // m^2: smaller triangles are omitted

struct Mesh {
    struct Triangle {
        std::array<int, 3> corners;        // counter-clockwise from the solid side
        Vec3 normal;                       // unit, towards that side
        std::array<bool, 3> sharp{};       // the edge from corner i to the next is convex or a
                                           // boundary; other edges do not affect sliding bodies
        std::array<bool, 3> slight{};      // it is convex, but bent too little to be sharp

        Vec3 middle;                       // m, mean of the corners
        double reach = 0.0;                // m, of the corners from there

        bool isAnySlight() const { return slight[0] || slight[1] || slight[2]; }
    };
    struct Node {
        Bounds bounds;
        int first = 0, count = 0;  // a leaf's triangles; count 0: an inner node
        int next = 0;              // node after this one's subtree
    };
    std::vector<Vec3> corners;  // m
    std::vector<Triangle> triangles;
    std::vector<Node> nodes;    // depth first: the first child of a node follows it
    std::vector<std::pair<int, int>> beside;  // corners joined by an edge, both ways, sorted; empty
                                              // if no edge is slight

    const Bounds& bounds() const { return nodes[0].bounds; }

    /// The corners joined to one by an edge.
    std::span<const std::pair<int, int>> besideOf(int corner) const {
        const auto first = std::ranges::lower_bound(beside, std::pair(corner, 0));
        return {first, std::ranges::lower_bound(beside, std::pair(corner + 1, 0))};
    }

    /// Calls visit(number), in order, for all triangles in leaves that overlap `within`.
    template <class Visit>
    void query(const Bounds& within, Visit visit) const {
        for (int i = 0; i < static_cast<int>(nodes.size());) {
            const Node& node = nodes[i];
            if (!node.bounds.overlaps(within)) {
                i = node.next;
                continue;
            }
            for (int k = node.first; k < node.first + node.count; ++k) visit(k);
            ++i;
        }
    }
};

/// Merges corners at the same place and omits triangles without an area.
Mesh makeMesh(std::span<const Vec3> corners, std::span<const std::array<int, 3>> triangles);

}  // namespace engine
