/// Solids of triangles: convex polyhedra, and scenery such as height fields.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "render/frame.h"

namespace render {

/// Three vertices each, by their places; counter-clockwise as seen from outside.
using MeshTriangles = std::vector<std::array<int, 3>>;

struct MeshTree;  // boxes around triangles, for rays; the renderer's own

/// {x : normal . x = offset}
struct MeshPlane {
    Vec3 normal{0, 1, 0};  // unit, outwards
    float offset = 0.0f;   // m
};

/// Which edges of a mesh are seen as edges: those of more than half a degree, those of more than 30
/// degrees, or none. Between the others the light changes smoothly.
enum class MeshEdges { all, sharp, none };

/// Plain values, made by makeMesh and not changed afterwards: frames share it.
struct SolidMesh {
    std::vector<Vec3> vertices;  // m, body axes
    MeshTriangles triangles;     // seen from outside only
    bool convex = false;         // a body; otherwise a surface

    // What drawing it and meeting it by rays take from that, by triangle.
    std::vector<Vec3> normals;               // unit
    std::vector<std::array<int, 3>> beyond;  // the triangle across edge i, from corner i to the
                                             // next one; -1: none
    std::vector<std::array<bool, 3>> crisp;  // whether that edge is seen as one
    bool anyCrisp = false;                   // whether there is such an edge
    std::vector<int> facets;                 // its number in a SurfaceMap: what lies together and
                                             // is hardly bent
    int facetCount = 0;                      // how many of these there are
    std::vector<MeshPlane> planes;  // by facet; of a convex mesh with all its edges, else none
    std::shared_ptr<const MeshTree> tree;    // of boxes around the triangles
    Vec3 halfSize{0, 0, 0};  // m, of the box around the origin that holds it
    float thinnest = 0.0f;   // m, half of the least of its sizes
};

/// Triangles without an area are left out. Throws Error where none is left, where a triangle names
/// a vertex that is not there, and where a vertex is not finite.
std::shared_ptr<const SolidMesh> makeMesh(std::vector<Vec3> vertices, MeshTriangles triangles,
                                          bool convex, MeshEdges edges);
/// A convex one with all its edges, another one with the sharp ones.
std::shared_ptr<const SolidMesh> makeMesh(std::vector<Vec3> vertices, MeshTriangles triangles,
                                          bool convex);

/// m: half of the box around a solid's position, along its own axes, that holds it.
Vec3 holdingHalfSize(const Solid& solid);

}  // namespace render
