/// What is drawn over the finished picture, in two dimensions and with exact coverage: contact dots,
/// arrows and text. On the processor: they are few, and the same on every driver.
#pragma once
#include <vector>

#include "render/camera.h"
#include "render/image.h"
#include "render/occlusion.h"

namespace render {

/// Markers behind something are left out; `depth` of any size, empty: nothing hides anything.
void drawMarkers(Image& image, const Frame& frame, const View& view, const DepthMap& depth);
void drawArrows(Image& image, const Frame& frame, const View& view);
/// Lines of text in the corners; sharp at every size, with a halo of the ground's tone.
void drawTexts(Image& image, const Frame& frame);

/// Width in pixels that a line of text takes at a cap-to-descender height of `pixels`.
float textWidth(const std::string& text, float pixels);

}  // namespace render
