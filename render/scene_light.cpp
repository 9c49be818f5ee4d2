#include "render/scene_light.h"

#include <algorithm>

#include "render/linear.h"

namespace render {

std::optional<std::size_t> floorOf(const Frame& frame) {
    for (std::size_t i = 0; i < frame.grounds.size(); ++i)
        if (frame.grounds[i].visible && frame.grounds[i].normal.y() >= 0.5f) return i;
    return {};
}

Vec3 groundLight(const Frame& frame) {
    constexpr float kSeen = 0.55f;
    const std::optional<std::size_t> floor = floorOf(frame);
    if (!floor) return {0.20f, 0.20f, 0.21f};
    const float facing = frame.grounds[*floor].normal.dot(frame.look.sunDirection.normalized());
    const Vec3 light = kSkyLight + std::max(facing, 0.0f) * kSunLight;
    return kSeen * light.cwiseProduct(linear(frame.look.ground));
}

Vec3 skyOn(const Frame& frame, const Ground& ground) {
    const float up = 0.5f + 0.5f * ground.normal.normalized().y();
    return up * kSkyLight + (1.0f - up) * groundLight(frame);
}

Vec3 sunOn(const Frame& frame, const Ground& ground) {
    const Vec3 normal = ground.normal.normalized();
    return std::max(normal.dot(frame.look.sunDirection.normalized()), 0.0f) * kSunLight;
}

Vec3 plainFloor(const Frame& frame, const Ground& ground) {
    return (skyOn(frame, ground) + sunOn(frame, ground)).cwiseProduct(linear(frame.look.ground));
}

Vec3 mirroredFloor(const Frame& frame, const Ground& ground) {
    const Vec3 root = plainFloor(frame, ground).cwiseMin(1.0f).cwiseSqrt();
    const Vec3 stored = (255.0f * root).array().round() / 255.0f;
    return stored.cwiseAbs2();
}

}  // namespace render
