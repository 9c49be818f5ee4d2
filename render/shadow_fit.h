/// The place of a shadow map in the world.
#pragma once
#include <Eigen/Geometry>

#include "render/frame.h"

namespace render {

struct ShadowFit {
    Vec3 toLight{0, 1, 0};                                       // unit
    Eigen::Matrix4f worldToLight = Eigen::Matrix4f::Identity();  // m: x, y across, z to the light
    int used[2] = {1, 1};                                        // texels of the map, in x and y
    Eigen::Vector2f half{1, 1};                                  // m, half of what they cover
    float depth = 1.0f;                                          // m, half of what it covers
    float texel = 0.01f;                                         // m
    int size = 1;                                                // texels per side of the map

    /// From the world (m) to texels, and to depths 0..1.
    Eigen::Matrix4f worldToTexels() const;
    bool operator==(const ShadowFit& other) const;
};

/// Around a solid, in the light's axes; m. `toLight`: the rotation of the world to them.
Eigen::AlignedBox3f lightBox(const Solid& solid, const Eigen::Matrix3f& toLight);

}  // namespace render
