/// Overlays drawn over the finished picture, in two dimensions and with exact coverage: ghosts,
/// lines, dots, arrows, names, texts and plates. They are drawn in C++, because they are few and
/// then are the same with every driver.
#pragma once
#include <vector>

#include "render/camera.h"
#include "render/glyphs.h"
#include "render/image.h"
#include "render/occlusion.h"
#include "render/surface_map.h"

namespace render {

/// Distance in m along the view axis at a pixel of the image; the map may have another size. For an
/// empty map it is very large.
inline float metersAt(const DepthMap& depth, const Image& image, int x, int y) {
    if (depth.meters.empty()) return 1e30f;
    return depth.at(x * depth.width / image.width, y * depth.height / image.height);
}

/// What bodies hide of the overlays.
struct Scenery {
    const DepthMap& depth;       // for all but ghosts; empty: nothing is hidden
    const SurfaceMap& surfaces;  // for ghosts: of the image's size, without glass; may be empty, too
};

/// Whether the frame has overlays that depths can hide.
bool needsDepth(const Frame& frame);

/// Draws all overlays, in the order below.
void drawOverlays(Image& image, const Frame& frame, const View& view, const Scenery& scenery);

/// True if the picture shows something clearly nearer there, by more than `reach` (m).
bool isHidden(const Projected& p, float reach, const Image& image, const DepthMap& depth);

/// Translucent silhouettes, clipped by bodies in front of them.
void drawGhosts(Image& image, const Frame& frame, const View& view, const SurfaceMap& surfaces);
/// Thin lines; faint where they are behind something.
void drawLines(Image& image, const Frame& frame, const View& view, const DepthMap& depth);
/// Markers behind something are left out.
void drawMarkers(Image& image, const Frame& frame, const View& view, const DepthMap& depth);
/// From back to front. Arrows that start behind something are faint, or left out if there are many.
void drawArrows(Image& image, const Frame& frame, const View& view, const DepthMap& depth);
/// An arrow on the picture itself; all in pixels.
void drawFlatArrow(Image& image, const Eigen::Vector2f& from, const Eigen::Vector2f& to,
                   const Color& color, const Look& look);
/// Texts, plates and names. None covers another; those without room are left out.
void drawTexts(Image& image, const Frame& frame, const View& view, const DepthMap& depth);

}  // namespace render
