/// Rays through points of the picture, four at a time, and where they enter a surface from outside,
/// as it is drawn. Single precision: a millionth of the distance is far below a pixel.
#pragma once
#include "render/four.h"
#include "render/ray_surface.h"
#include "render/sight.h"

namespace render {

/// Where four rays enter. t is infinite for a ray that misses; the face is as in a SurfaceMap.
struct FourHits {
    Four t{};
    FourInts face{};
};

/// One surface, prepared for the rays of one camera.
class SeenSurface {
public:
    SeenSurface(const Surface& surface, const Sight& sight);
    FourHits enter(Four x, Four y) const;

private:
    struct Rays;
    FourHits enterBox(const Rays& rays) const;
    FourHits enterCapsule(const Rays& rays) const;
    FourHits enterBar(const Rays& rays) const;
    FourHits enterPlane(const Rays& rays) const;
    FourHits enterCylinder(const Rays& rays) const;
    FourHits enterCone(const Rays& rays) const;
    FourHits enterHull(const Rays& rays) const;
    FourHits enterMesh(const Rays& rays) const;

    SurfaceKind kind_;
    const SolidMesh* mesh_;
    Vec3 half_;                       // m, as in Surface
    Vec3 eye_, ahead_, right_, down_;  // the Sight, in the surface's axes
};

}  // namespace render
