/// Anti-aliasing of a picture drawn with one sample per pixel: more samples, at edges only.
#pragma once
#include "render/edge_rays.h"
#include "render/image.h"
#include "render/pixel_rect.h"
#include "render/surface_map.h"

namespace render {

/// For every pixel next to one with another surface, casts `samples` rays (1, 2, 4, 8 or 16; 1:
/// does nothing), finds which of the surfaces around the pixel each ray hits, and takes the mean of
/// their colours. `map`: the surfaces of `frame` in `view` at the pixels' centres.
/// A surface that no pixel's centre hits is not found; nothing is drawn thinner than a pixel.
void smoothEdges(Image& image, SurfaceMap map, const Frame& frame, const View& view, int samples);

/// The same in the rectangles `where` only, from `image` to `smooth`. `samples`: at least 2. `map`:
/// its faces are joined (joined_faces.h), in `fresh` only here; `fresh` holds `where` and the pixels
/// around it that differ from the last time.
void smoothEdges(const Image& image, SurfaceMap& map, const PixelRect& fresh,
                 const std::vector<PixelRect>& where, const Frame& frame, const View& view,
                 int samples, Image& smooth);

}  // namespace render
