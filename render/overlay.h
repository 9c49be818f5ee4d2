/// What is drawn over the finished picture, in two dimensions and with exact coverage: ghosts,
/// lines, dots, arrows, names, texts and plates. On the processor: they are few, and the same on
/// every driver.
#pragma once
#include <vector>

#include "render/camera.h"
#include "render/glyphs.h"
#include "render/image.h"
#include "render/occlusion.h"

namespace render {

/// m along the view axis, of what is seen at a pixel of the image; the map may have another size.
/// Empty: nothing is seen, far away.
inline float metersAt(const DepthMap& depth, const Image& image, int x, int y) {
    if (depth.meters.empty()) return 1e30f;
    return depth.at(x * depth.width / image.width, y * depth.height / image.height);
}

/// Whether the frame has anything that others can hide.
bool needsDepth(const Frame& frame);

/// Everything, in this order.
void drawOverlays(Image& image, const Frame& frame, const View& view, const DepthMap& depth);

/// True when the picture shows something clearly nearer at that place, by more than `reach` (m).
bool isHidden(const Projected& p, float reach, const Image& image, const DepthMap& depth);

/// Translucent silhouettes; what is in front of them cuts them off.
void drawGhosts(Image& image, const Frame& frame, const View& view, const DepthMap& depth);
/// Thin lines; faint where they are behind something.
void drawLines(Image& image, const Frame& frame, const View& view, const DepthMap& depth);
/// Markers behind something are left out.
void drawMarkers(Image& image, const Frame& frame, const View& view, const DepthMap& depth);
/// From back to front; faint where they start behind something, or left out where there are many.
void drawArrows(Image& image, const Frame& frame, const View& view, const DepthMap& depth);
/// An arrow on the picture itself; all in pixels.
void drawFlatArrow(Image& image, const Eigen::Vector2f& from, const Eigen::Vector2f& to,
                   const Color& color, const Look& look);
/// Texts, plates and names. Nothing covers anything else; what has no room is left out.
void drawTexts(Image& image, const Frame& frame, const View& view, const DepthMap& depth);

}  // namespace render
