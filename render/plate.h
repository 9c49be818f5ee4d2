/// A table on a translucent background: swatches, names, values, bars, colour scales.
#pragma once
#include "render/corners.h"
#include "render/image.h"

namespace render {

void drawPlate(Image& image, const PlacedPlate& placed, const Look& look, float pixelsPerMeter);

}  // namespace render
