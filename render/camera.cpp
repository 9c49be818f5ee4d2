#include "render/camera.h"

#include <algorithm>
#include <cmath>

#include "render/pi.h"

namespace render {

Eigen::Matrix4f lookAt(const Vec3& eye, const Vec3& target, const Vec3& up) {
    // An eye at its own target looks along -z; the scene reader rejects it with a message.
    const Vec3 way = eye - target;
    const Vec3 back = way.norm() > 1e-6f ? Vec3(way.normalized()) : Vec3(Vec3::UnitZ());
    Vec3 right = up.cross(back);
    if (right.norm() < 1e-4f) right = Vec3(0, 0, -1).cross(back);  // looking along `up`
    right.normalize();
    Eigen::Matrix4f m = Eigen::Matrix4f::Identity();
    m.block<1, 3>(0, 0) = right.transpose();
    m.block<1, 3>(1, 0) = back.cross(right).transpose();
    m.block<1, 3>(2, 0) = back.transpose();
    m.block<3, 1>(0, 3) = -m.block<3, 3>(0, 0) * eye;
    return m;
}

namespace {

constexpr float kNearest = 0.02f, kNearestAboveGround = 5e-4f;  // of the distance to what the camera looks at

void setDepths(float nearest, View& v) {
    v.nearest = nearest;
    v.projection(2, 2) = (v.farthest + v.nearest) / (v.nearest - v.farthest);
    v.projection(2, 3) = 2.0f * v.farthest * v.nearest / (v.nearest - v.farthest);
}

/// Along the view axis, m: where the first ray through a corner of the picture meets the ground.
float depthOf(const Ground& ground, const View& v) {
    const float above = ground.normal.dot(v.eye) - ground.offset;
    const Vec3 axes = (above < 0.0f ? -1.0f : 1.0f) * (v.view.block<3, 3>(0, 0) * ground.normal);  // right, up, back
    const float closing =
        axes.z() + std::abs(axes.x()) / v.projection(0, 0) + std::abs(axes.y()) / v.projection(1, 1);
    return closing > 0.0f ? std::abs(above) / closing : v.farthest;
}

}  // namespace

View makeView(const Camera& camera, float aspect) {
    View v;
    v.eye = camera.from;
    v.view = lookAt(camera.from, camera.lookAt, camera.up);
    const float distance = (camera.from - camera.lookAt).norm();
    v.farthest = 150.0f * std::max(distance, 4.0f);
    const float f = 1.0f / std::tan(0.5f * camera.fovDegrees * kPi / 180.0f);
    v.projection.setZero();
    v.projection(0, 0) = f / aspect;
    v.projection(1, 1) = f;
    v.projection(3, 2) = -1.0f;
    setDepths(std::max(kNearest * distance, 0.01f), v);
    return v;
}

View frameView(const Frame& frame, float aspect) {
    View v = makeView(frame.camera, aspect);
    const float least = v.nearest * (kNearestAboveGround / kNearest);
    for (const Ground& ground : frame.grounds) {
        const float depth = ground.visible ? 0.9f * depthOf(ground, v) : v.farthest;
        if (depth < v.nearest) setDepths(std::max(depth, least), v);
    }
    return v;
}

Projected project(const View& view, const Vec3& world, int width, int height) {
    const Eigen::Vector4f clip = view.worldToClip() * world.homogeneous();
    const float w = clip.w();
    if (w <= view.nearest) return {0, 0, 0};
    return {(0.5f + 0.5f * clip.x() / w) * static_cast<float>(width),
            (0.5f - 0.5f * clip.y() / w) * static_cast<float>(height), w};
}

float gridCell(const Camera& camera) {
    const float decade = std::floor(std::log10((camera.from - camera.lookAt).norm() / 6.0f));
    return std::max(std::pow(10.0f, decade), 0.1f);
}

}  // namespace render
