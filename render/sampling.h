/// Sample positions: of several samples in one pixel, and of a picture's sub-frames.
#pragma once
#include <vector>

#include "render/frame.h"

namespace render {

struct SampleOffset {
    float x, y;  // pixels from a pixel's middle
};

/// Of 2, 4, 8 or 16 samples; of 2 each comes twice, to fill four. No two are in one row or column, so
/// that a nearly vertical or horizontal edge gets all steps.
std::vector<SampleOffset> sampleOffsets(int samples);

/// One sub-frame: in the pixel, on the sun's disc, on the lens. Each set is spread evenly, and no two
/// are correlated.
struct SubSample {
    Eigen::Vector2f pixel{0, 0};  // from the middle, -0.5..0.5
    Vec3 toSun{0, 1, 0};          // unit
    Eigen::Vector2f lens{0, 0};   // on a disc of radius 1
    float turn = 0.0f;            // 0..1, rotation of the ambient occlusion pattern
};

/// Sample `index` of `count`; the sun's disc is centred on `sun`.
SubSample subSample(int index, int count, const Vec3& sun);

}  // namespace render
