/// The place of a shadow map in the world.
#pragma once
#include <Eigen/Geometry>

#include "render/camera.h"
#include "render/frame.h"

namespace render {

struct ShadowFit {
    Vec3 toLight{0, 1, 0};                                       // unit
    Eigen::Matrix4f worldToLight = Eigen::Matrix4f::Identity();  // m: x, y across, z to the light
    float texel = 0.01f;                                         // m
    float depth = 1.0f;                                          // m, half of what it covers
    int size = 4;                                                // texels per side of the map

    /// m: half of what is drawn of the map, which is all but a rim of one texel. The rim stays empty: what
    /// lies beside the map is lit.
    float half() const { return 0.5f * texel * static_cast<float>(size - 2); }
    /// From the world (m) to texels, and to depths 0..1.
    Eigen::Matrix4f worldToTexels() const;
    bool operator==(const ShadowFit& other) const;
};

/// For a map of `size` texels per side. `toLight`: of any length. The fit depends on this frame only; with a
/// camera that stands still it hardly ever differs from that of the frame before.
ShadowFit fitShadow(const Frame& frame, const View& view, const Vec3& toLight, int size);

/// Around a solid, in the light's axes; m. `toLight`: the rotation of the world to them.
Eigen::AlignedBox3f lightBox(const Solid& solid, const Eigen::Matrix3f& toLight);

}  // namespace render
