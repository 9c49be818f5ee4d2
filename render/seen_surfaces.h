/// The surfaces of a frame as rays through the picture meet them.
#pragma once
#include <optional>
#include <vector>

#include "render/edge_rays.h"

namespace render {

/// By number, as in a SurfaceMap. Thin rods are as wide as they are drawn. Each surface is prepared
/// for the camera when it is first needed.
class SeenSurfaces {
public:
    /// `width`, `height` of the picture, pixels.
    SeenSurfaces(const Frame& frame, const View& view, int width, int height);

    const SeenSurface& operator[](int surface);
    const std::vector<Surface>& surfaces() const { return surfaces_; }
    const Sight& sight() const { return sight_; }

private:
    std::vector<Surface> surfaces_;
    Sight sight_;
    std::vector<std::optional<SeenSurface>> seen_;
};

}  // namespace render
