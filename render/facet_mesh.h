/// Cylinder, cone and meshes as triangles that know how far they are from the edges that are seen.
#pragma once
#include "render/solid_mesh.h"
#include "render/vertex.h"

namespace render {

/// Of radius 1, from y = -1 to 1, of so many corners around.
std::vector<FacetVertex> cylinderMesh(int corners);
/// Of radius 1, from y = -0.5 to the tip at y = 1.5.
std::vector<FacetVertex> coneMesh(int corners);
/// In metres.
std::vector<FacetVertex> facetMesh(const SolidMesh& mesh);

}  // namespace render
