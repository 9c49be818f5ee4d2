/// A bounding volume hierarchy of boxes, so that a ray is tested against few triangles.
#pragma once
#include <array>
#include <limits>
#include <vector>

#include "render/four.h"
#include "render/solid_mesh.h"

namespace render {

struct MeshTree {
    struct Node {
        Vec3 low{0, 0, 0}, high{0, 0, 0};  // m
        int first = 0, count = 0;          // of a leaf, in `order`; count 0: has two children
        int second = 0;                    // the second child; the first is the next node
        int axis = 0;                      // along which they were split
    };
    std::vector<Node> nodes;
    std::vector<int> order;  // triangles, leaf by leaf
};

MeshTree treeOf(const std::vector<Vec3>& vertices, const MeshTriangles& triangles);

/// Four rays from + t along.
struct FourRays {
    Vec3 from{0, 0, 0};
    Four along[3];
};

/// The t of a ray that hits nothing.
inline constexpr float kNever = std::numeric_limits<float>::infinity();

struct FourTriangles {
    Four t{};             // kNever for a miss
    FourInts triangle{};  // -1 there
};

/// The nearest triangles in front of the rays that they hit from outside (Moeller and Trumbore
/// 1997). `facet`: tests only this one, numbered as in a SurfaceMap; -1: all.
FourTriangles nearestTriangles(const SolidMesh& mesh, const FourRays& rays, int facet = -1);

}  // namespace render
