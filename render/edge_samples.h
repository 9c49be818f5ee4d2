/// Many samples a pixel, where it pays: at the edges of a picture that was drawn with one.
#pragma once
#include "render/edge_rays.h"
#include "render/image.h"
#include "render/surface_map.h"

namespace render {

/// For every pixel that has another surface beside it, looks along `samples` rays (1, 2, 4, 8 or
/// 16; 1: does nothing) which of the surfaces around it each of them meets, and takes the mean of
/// these surfaces' colours. `map`: the surfaces at the pixels' centres, of `frame` in `view`.
/// What no pixel's centre meets is not found: nothing is drawn thinner than a pixel.
void smoothEdges(Image& image, SurfaceMap map, const Frame& frame, const View& view, int samples);

}  // namespace render
