/// Where the sub-frames of a picture take their samples: in the pixel, on the sun's disc, on the
/// lens. Each is spread evenly by itself, and no two go together.
#pragma once
#include "render/frame.h"

namespace render {

struct SubSample {
    Eigen::Vector2f pixel{0, 0};  // from the middle, -0.5..0.5
    Vec3 toSun{0, 1, 0};          // unit
    Eigen::Vector2f lens{0, 0};   // on a disc of radius 1
    float turn = 0.0f;            // 0..1, of the pattern of what samples surroundings
};

/// Number `index` of `count`, for light from around `sun`.
SubSample subSample(int index, int count, const Vec3& sun);

}  // namespace render
