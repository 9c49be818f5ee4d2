/// The light of a picture in linear values: what the sky, the sun and the ground send.
#pragma once
#include <cstddef>
#include <optional>

#include "render/frame.h"

namespace render {

inline const Vec3 kSkyLight(0.40f, 0.44f, 0.50f), kSunLight(1.06f, 1.00f, 0.90f);

/// The first visible ground that faces up.
std::optional<std::size_t> floorOf(const Frame& frame);

/// Light from below: sky and sun, reflected by the floor, parts of which lie in shadows.
Vec3 groundLight(const Frame& frame);

/// Light of the sky, without the sun, that a ground receives where nothing is near.
Vec3 skyOn(const Frame& frame, const Ground& ground);
/// The sun's, outside of shadows.
Vec3 sunOn(const Frame& frame, const Ground& ground);
/// What leaves a ground without a grid where nothing is near.
Vec3 plainFloor(const Frame& frame, const Ground& ground);
/// The same as a picture of 8-bit square roots shows it.
Vec3 mirroredFloor(const Frame& frame, const Ground& ground);

}  // namespace render
