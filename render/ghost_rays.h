/// Intersects the rays through a picture's pixels with a ghost.
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
    /// `sun`: direction towards the sun, unit.
    GhostRays(const Solid& ghost, const View& view, const Vec3& sun, int width, int height);
    /// `pixel`: from the upper left corner.
    std::optional<GhostHit> at(const Vec2& pixel) const;
    /// Approximate distance of the ghost's middle, m along the view axis.
    float middle(const Vec2& pixel) const { return from_.norm() / through(pixel).norm(); }

private:
    Vec3 through(const Vec2& p) const { return corner_ + p.x() * right_ + p.y() * down_; }
    std::optional<GhostHit> onSurface(const Vec2& pixel) const;

    const Solid& ghost_;
    // In the ghost's axes: the eye; the direction through the upper left corner of the picture, 1 m
    // along the view axis; the step of one pixel right and down.
    Vec3 from_, corner_, right_, down_;
    Vec3 sun_, sunInGhost_;
    Surface surface_;
    Sight sight_;
    SeenSurface seen_;
};

}  // namespace render
