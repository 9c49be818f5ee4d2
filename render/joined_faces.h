/// Facets of meshes between which a camera sees no edge.
#pragma once
#include <vector>

#include "render/ray_surface.h"
#include "render/surface_map.h"

namespace render {

/// By surface and face the face that stands for it; where a surface's are empty each is itself.
using FaceTables = std::vector<std::vector<int>>;

/// Empty when no surface is a mesh. A facet that ends nowhere before the eye, neither at a crisp
/// edge nor at one beyond which the mesh faces away or is no more, hides none of its neighbours:
/// all such facets of a mesh become one.
FaceTables joinedFaces(const std::vector<Surface>& surfaces, const Vec3& eye);

SurfaceMap joined(SurfaceMap map, const FaceTables& tables);

}  // namespace render
