/// Ambient occlusion: how much of the sky is visible from a point, computed from the depths around
/// it (McGuire et al. 2011, 'The alchemy screen-space ambient obscurance algorithm'). It runs in
/// C++: with a software driver, depth lookups in a shader cost four times as much.
#pragma once
#include <cstdint>
#include <vector>

#include "render/tile_set.h"

namespace render {

/// Distances along the view axis, row 0 on top.
struct DepthMap {
    int width = 0, height = 0;
    std::vector<float> meters;
    float at(int x, int y) const { return meters[static_cast<std::size_t>(y) * width + x]; }
};

/// One byte per pixel, row 0 on top.
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
    float farthest = 1000.0f;          // m: nothing is darkened beyond 0.6 of it
    float reach = 0.5f;                // m: surfaces farther away hide nothing
    int radius = 64;                   // pixels of the map: no sample is farther from its point
    std::vector<PixelRect> where;      // of the map: full openness elsewhere
};

/// 255 = all of the sky is visible, 0 = none. Eight samples per pixel, blurred over their pattern.
ByteMap openness(const DepthMap& depth, const OcclusionSettings& settings);

/// openness() of one map after another, of which only what differs is computed.
class KeptOpenness {
public:
    static constexpr int kSide = 8;  // of a tile, in pixels of the map

    /// `changed`: tiles with other depths than the last time, of a map of the same size with the
    /// same lens, reach and farthest depth; null: all. The tiles of the map that differ.
    TileSet renew(const DepthMap& depth, const OcclusionSettings& settings,
                  const TileSet* changed);
    const ByteMap& map() const { return map_; }

private:
    TileSet tilesToRenew(const PixelRect& bounds, const TileSet& held, const TileSet& changed,
                         int radius) const;
    ByteMap map_;
    std::vector<float> open_;  // before it is blurred
    TileSet held_;             // those of `where`
    PixelRect bounds_;         // of `where`
};

/// The same from four samples per pixel, without the blur. `turn` (0..1 of a full turn) rotates
/// their directions; the result is meant to be averaged over many turns.
ByteMap roughOpenness(const DepthMap& depth, const OcclusionSettings& settings, float turn);

/// A part of the map at twice the width and height, or one pixel more: 3/4 of the nearest and 1/4
/// of the next pixel. `where`: in the large map.
ByteMap doubled(const ByteMap& map, const PixelRect& where);

/// The largest distance of a point's samples from it, in pixels of a map of this height.
/// `nearest`: m, to the nearest surface seen.
int occlusionRadius(const OcclusionSettings& settings, float nearest, int height);

}  // namespace render
