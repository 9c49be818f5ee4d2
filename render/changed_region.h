/// The parts of the picture that may differ between two frames of one view.
#pragma once
#include <optional>

#include "render/body_places.h"

namespace render {

/// Where two frames differ: all else has the same pixels in both, except for ambient occlusion.
struct ChangedRegion {
    TileSet bodies;    // old and new places of bodies and trails
    TileSet shadows;   // old and new places of their shadows
    TileSet texels;    // of the shadow map
};

/// `view`: of both frames, not upside down. `sun`: of both frames; null: no shadows. Nothing:
/// everything may differ.
std::optional<ChangedRegion> changedRegion(const Frame& before, const Frame& now, const View& view,
                                           int width, int height, const ShadowFit* sun);

}  // namespace render
