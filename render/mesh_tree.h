/// Boxes around boxes around triangles, so that a ray is tried against few of them.
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
        int first = 0, count = 0;          // of a leaf, in `order`; count 0: two nodes below
        int second = 0;                    // the second of these; the first is the next node
        int axis = 0;                      // along which they were parted
    };
    std::vector<Node> nodes;
    std::vector<int> order;  // triangles, leaf by leaf
};

MeshTree treeOf(const std::vector<Vec3>& vertices, const MeshTriangles& triangles);

/// from + t along, four of them.
struct FourRays {
    Vec3 from{0, 0, 0};
    Four along[3];
};

/// The t of a ray that meets nothing.
inline constexpr float kNever = std::numeric_limits<float>::infinity();

struct FourTriangles {
    Four t{};             // kNever where nothing is met
    FourInts triangle{};  // -1 there
};

/// The nearest triangles that the rays meet from outside, in front of them (Moeller and Trumbore
/// 1997). `facet`: of this one alone, as a SurfaceMap has it; -1: of all.
FourTriangles nearestTriangles(const SolidMesh& mesh, const FourRays& rays, int facet = -1);

}  // namespace render
