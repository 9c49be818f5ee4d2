/// Where the rays of a picture's pixels enter a ghost.
#pragma once
#include <optional>

#include "render/coverage.h"
#include "render/edge_rays.h"

namespace render {

struct GhostHit {
    float distance = 0.0f;  // m along the view axis
    float facing = 0.0f;    // cosine of the angle between the normal and the sun
};

class GhostRays {
public:
    /// `sun`: towards it, unit.
    GhostRays(const Solid& ghost, const View& view, const Vec3& sun, int width, int height);
    /// `pixel`: from the upper left corner.
    std::optional<GhostHit> at(const Vec2& pixel) const;
    /// m along the view axis to the ghost's middle, about.
    float middle(const Vec2& pixel) const { return from_.norm() / through(pixel).norm(); }

private:
    Vec3 through(const Vec2& p) const { return corner_ + p.x() * right_ + p.y() * down_; }
    std::optional<GhostHit> onSurface(const Vec2& pixel) const;

    const Solid& ghost_;
    // In the ghost's axes: the eye; the way through the upper left corner of the picture, 1 m along
    // the view axis; a pixel on, either way.
    Vec3 from_, corner_, right_, down_;
    Vec3 sun_, sunInGhost_;
    Surface surface_;
    Sight sight_;
    SeenSurface seen_;
};

}  // namespace render
