/// The view of an image in a plane mirror.
#pragma once
#include "render/camera.h"

namespace render {

bool isAbove(const Vec3& point, const Ground& ground);

/// The view that shows the bodies at the pixels where `view` shows their image in the ground; what is
/// below the ground is cut off. Triangles turn the other way round.
View mirroredView(const View& view, const Ground& ground);

}  // namespace render
