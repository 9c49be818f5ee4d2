/// A ground plane as triangles: what lies in the shadow map's footprint apart from all the rest,
/// which needs no look into the map.
#pragma once
#include <vector>

#include "render/camera.h"

namespace render {

struct GroundCorners {
    std::vector<Vec3> inside, around;  // m, three to a triangle, with common edges
    Vec3 across, along;                // unit, the grid's axes on the plane
};

/// `footprint`: four corners on the plane, in order; none: everything is around.
GroundCorners groundCorners(const Ground& ground, const View& view,
                            const std::vector<Vec3>& footprint);

/// So many rows from the top may show something else than ground behind the bodies.
int rowsOfSky(const Frame& frame, const View& view, int width, int height);

}  // namespace render
