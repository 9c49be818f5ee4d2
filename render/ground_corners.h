/// A ground plane as triangles. Those inside the shadow map's footprint are separate from the rest,
/// which needs no lookup in the map.
#pragma once
#include <vector>

#include "render/camera.h"

namespace render {

struct GroundCorners {
    std::vector<Vec3> inside, around;  // m, three per triangle, with common edges
    Vec3 across, along;                // unit, the grid's axes on the plane
};

/// `footprint`: four corners on the plane, in order; empty: every triangle is in `around`.
GroundCorners groundCorners(const Ground& ground, const View& view,
                            const std::vector<Vec3>& footprint);

/// The number of rows from the top in which something other than ground may be behind the bodies.
int rowsOfSky(const Frame& frame, const View& view, int width, int height);

}  // namespace render
