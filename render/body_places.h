/// Where bodies may be in a picture, and in a shadow map: never too small.
#pragma once
#include "render/shadow_fit.h"
#include "render/tile_set.h"

namespace render {

inline constexpr int kTile = 16;  // pixels; a multiple of the 2x2 that are shaded together

/// In the axes of a ShadowFit, m.
using LightBox = Eigen::AlignedBox3f;

/// Adds the faces of the box around a solid.
void addShape(const Solid& s, ShapeTiles& shape);
/// Adds a rod as it is drawn in a picture of this height. False, and nothing is added, if it comes
/// so near to the eye that it may be anywhere.
bool addShape(const Rod& rod, const View& view, int height, ShapeTiles& shape);

/// Around a rod of this drawn radius (m).
LightBox lightBox(const Rod& rod, float radius, const Eigen::Matrix3f& toLight);

/// The texels that a body in this box may cover; empty if it is beside the map.
PixelRect texelsUnder(const LightBox& box, const ShadowFit& fit);
/// By number of its surface: those that a solid or rod of a frame may cover. `height`:
/// of the picture.
std::vector<PixelRect> texelsUnder(const Frame& frame, const View& view, int height,
                                   const ShadowFit& fit);

/// By how much a shadow's edge and errors of rounding may widen it, m.
float shadowMargin(const ShadowFit& fit);
/// Adds the shadow of a body in this box on a ground. False, and nothing is added, if it may be anywhere.
bool addShadow(const LightBox& box, const Ground& ground, const ShadowFit& fit, ShapeTiles& shape);
/// Around the shadows of all bodies on all grounds in the picture.
PixelRect groundShadows(const Frame& frame, const View& view, int width, int height,
                        const ShadowFit& fit);

/// Parts of a shadow map; empty.
inline TileSet texelTiles(const ShadowFit& fit) { return {fit.size, fit.size, 4 * kTile}; }

/// By number of its surface: whether a solid or rod may be in any of these tiles of `kTile` pixels.
std::vector<char> bodiesIn(const TileSet& tiles, const Frame& frame, const View& view, int width,
                           int height);

}  // namespace render
