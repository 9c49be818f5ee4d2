/// Solids made of triangles: convex polyhedra, and scenery such as height fields.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "render/frame.h"

namespace render {

/// Three indices of vertices each; counter-clockwise as seen from outside.
using MeshTriangles = std::vector<std::array<int, 3>>;

struct MeshTree;  // boxes around triangles, for rays; internal to the renderer

/// {x : normal . x = offset}
struct MeshPlane {
    Vec3 normal{0, 1, 0};  // unit, outwards
    float offset = 0.0f;   // m
};

/// Which edges of a mesh are drawn as edges: those of more than half a degree, those of more than
/// 30 degrees, or none. Across the others the shading is smooth.
enum class MeshEdges { all, sharp, none };

/// Plain values, made by makeMesh() and never changed afterwards: frames share a mesh.
struct SolidMesh {
    std::vector<Vec3> vertices;  // m, body axes
    MeshTriangles triangles;     // seen from outside only
    bool convex = false;         // a body; otherwise a surface

    // Derived from the above, for drawing and for rays; by triangle.
    std::vector<Vec3> normals;               // unit
    std::vector<std::array<int, 3>> beyond;  // the triangle across edge i, from corner i to the
                                             // next one; -1: none
    std::vector<std::array<bool, 3>> crisp;  // whether that edge is drawn as one
    bool anyCrisp = false;                   // whether there is such an edge
    std::vector<int> facets;                 // its face in a SurfaceMap: adjacent triangles that
                                             // are almost coplanar
    int facetCount = 0;                      // number of facets
    std::vector<MeshPlane> planes;  // by facet; for a convex mesh with MeshEdges::all, else empty
    std::shared_ptr<const MeshTree> tree;    // of boxes around the triangles
    Vec3 halfSize{0, 0, 0};  // m, of the box centred on the origin that contains it
    float thinnest = 0.0f;   // m, half of its smallest extent
};

/// Triangles without an area are left out. Throws Error if none is left, if a triangle refers to a
/// missing vertex, or if a vertex is not finite.
std::shared_ptr<const SolidMesh> makeMesh(std::vector<Vec3> vertices, MeshTriangles triangles,
                                          bool convex, MeshEdges edges);
/// MeshEdges::all for a convex mesh, MeshEdges::sharp for others.
std::shared_ptr<const SolidMesh> makeMesh(std::vector<Vec3> vertices, MeshTriangles triangles,
                                          bool convex);

/// m: half size of the box around a solid's position, along its own axes, that contains it.
Vec3 holdingHalfSize(const Solid& solid);

}  // namespace render
