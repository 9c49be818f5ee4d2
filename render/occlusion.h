/// Ambient occlusion: how much of the sky a point sees, from the depths around it (McGuire et al.
/// 2011, 'The alchemy screen-space ambient obscurance algorithm'). On the processor: looking up
/// depths costs a software driver four times as much.
#pragma once
#include <cstdint>
#include <vector>

#include "render/pixel_rect.h"

namespace render {

/// Distances along the view axis, row 0 on top.
struct DepthMap {
    int width = 0, height = 0;
    std::vector<float> meters;
    float at(int x, int y) const { return meters[static_cast<std::size_t>(y) * width + x]; }
};

/// A byte a pixel, row 0 on top.
struct ByteMap {
    int width = 0, height = 0;
    std::vector<std::uint8_t> bytes;
    std::uint8_t* row(int y) { return bytes.data() + static_cast<std::size_t>(y) * width; }
    const std::uint8_t* row(int y) const {
        return bytes.data() + static_cast<std::size_t>(y) * width;
    }
};

struct OcclusionSettings {
    float lensX = 1.0f, lensY = 1.0f;  // tan of half the angles of view
    float farthest = 1000.0f;          // m: beyond 0.6 of it nothing is dark
    float reach = 0.5f;                // m: what is farther away hides nothing
    std::vector<PixelRect> where;      // of the map: all is open elsewhere
};

/// 255 = sees all of the sky, 0 = nothing. Eight samples a pixel, blurred over their pattern.
ByteMap openness(const DepthMap& depth, const OcclusionSettings& settings);

/// The same from four samples a pixel in directions that `turn` (0..1 of a full one) decides, with
/// the pattern left in: to be averaged over many turns.
ByteMap roughOpenness(const DepthMap& depth, const OcclusionSettings& settings, float turn);

/// A part of the map twice as wide and high, or one more than that: 3/4 of the nearest and 1/4 of
/// the next one. `where`: in the large map.
ByteMap doubled(const ByteMap& map, const PixelRect& where);

/// How far a point's samples may lie from it, in pixels of a map of this height; `nearest`: m, to
/// the first thing seen.
int occlusionRadius(const OcclusionSettings& settings, float nearest, int height);

}  // namespace render
