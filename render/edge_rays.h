/// Rays through points of the picture, four side by side, and where they enter a surface as it is
/// drawn: from outside. Single precision: a millionth of the distance is far below a pixel.
#pragma once
#include "render/four.h"
#include "render/ray_surface.h"
#include "render/sight.h"

namespace render {

/// Where four rays enter: t is infinite where they miss; the face as in a SurfaceMap.
struct FourHits {
    Four t{};
    FourInts face{};
};

/// One surface as one camera's rays see it.
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
    Vec3 half_;                       // m, as the surface's
    Vec3 eye_, ahead_, right_, down_;  // the sight, in the surface's own axes
};

}  // namespace render
