/// One ray through each pixel of a picture, and eight where neighbours differ: which part of a ghost is
/// seen there.
#pragma once
#include <array>

#include "render/coverage.h"
#include "render/seen_surfaces.h"
#include "render/surface_map.h"

namespace render {

/// What a picture shows besides ghosts, and may hide them.
struct Hiding {
    const SurfaceMap& map;  // without glass; empty: hides nothing
    SeenSurfaces& seen;     // of the same frame
};

/// A ghost in one pixel.
struct GhostPixel {
    float seen = 0.0f;  // 0..1: of the rays that meet the ghost (with hollows, of all), those that meet
                        // nothing before it
    float facing = 0.0f;   // mean cosine of the angle between its normal and the sun; below 0: 0
    float mirrored = 0.0f;  // 0..1: mean share of the light that glass reflects at this angle
};

class GhostRays {
public:
    /// `sun`: direction towards the sun, unit. `range`: of the ghost's silhouette, not empty.
    GhostRays(const Solid& ghost, const Vec3& sun, const Hiding& hiding, const PixelRange& range);
    /// The pixel must be in the range. Where its rays miss the ghost, along the silhouette's rim, they
    /// count as hits as far away as the ghost's middle; with hollows they count as hidden.
    GhostPixel at(int x, int y);
    /// Its silhouette is not convex, and is that of the rays.
    bool hollow() const { return hollow_; }

private:
    struct Met {
        FourInts hit;    // -1 for rays that meet the ghost
        FourInts first;  // and for those that meet it, or its rim, before anything else
        FourInts face;
    };
    /// Of four rays; `before`: where they meet something else.
    Met meet(Four x, Four y, Four before) const;
    Four beforeFour(int x, int y, Four px, Four py) const;
    void castCentres();
    bool sameAround(int x, int y) const;
    void lookAround(int x, int y);
    Four nearest(Four x, Four y);
    GhostPixel sampled(int x, int y);
    GhostPixel shade(const Eigen::Vector2f& at, int face) const;

    static constexpr int kRays = 8;

    const Hiding& hiding_;
    Vec3 sun_;
    bool hollow_;
    float middle_;  // m along the view axis
    Surface surface_;
    SeenSurface seen_;
    std::array<Four, kRays / kFour> x_{}, y_{};  // of the rays, from a pixel's corner
    std::vector<Vec3> normals_;  // by face, of boxes and hulls
    PixelRange range_;
    int stride_;
    std::vector<int> centres_;  // of the range, row by row: a face, or kHidden or kMissed
    std::array<int, 9> around_{};  // the surfaces of the pixel and its neighbours, each once
    std::size_t count_ = 0;
};

}  // namespace render
