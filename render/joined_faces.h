/// Joins the facets of meshes between which a camera sees no edge.
#pragma once
#include <vector>

#include "render/pixel_rect.h"
#include "render/ray_surface.h"
#include "render/surface_map.h"

namespace render {

/// By surface and face: the face that represents it. If a surface's table is empty, each face
/// represents itself.
using FaceTables = std::vector<std::vector<int>>;

/// Empty if no surface is a mesh. A facet without a visible border (a crisp edge, or one beyond
/// which the mesh faces away or ends) hides none of its neighbours: all such facets of a mesh
/// become one.
FaceTables joinedFaces(const std::vector<Surface>& surfaces, const Vec3& eye);

/// Replaces the faces in a part of a map by those that they are joined with. Twice is as
/// good as once.
void joinFaces(SurfaceMap& map, const PixelRect& where, const FaceTables& tables);

}  // namespace render
