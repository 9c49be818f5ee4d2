/// Cylinder, cone and meshes as triangles whose corners store the distance to the visible edges.
#pragma once
#include "render/solid_mesh.h"
#include "render/vertex.h"

namespace render {

/// Radius 1, from y = -1 to 1, with this many corners around.
std::vector<FacetVertex> cylinderMesh(int corners);
/// Radius 1, from y = -0.5 to the tip at y = 1.5.
std::vector<FacetVertex> coneMesh(int corners);
/// In metres.
std::vector<FacetVertex> facetMesh(const SolidMesh& mesh);

}  // namespace render
