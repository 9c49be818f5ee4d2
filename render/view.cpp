#include "render/view.h"

#include <cmath>
#include <numbers>
#include <string>

#include "render/error.h"

namespace render {
namespace {

void requireCamera(const Camera& camera) {
    if (!camera.from.allFinite() || !camera.lookAt.allFinite() || !camera.up.allFinite())
        throw Error("camera: a coordinate of from, lookAt or up is not finite");
    if ((camera.lookAt - camera.from).norm() < 1e-4f)
        throw Error("camera: from and lookAt are the same point; put them 0.1 mm apart or more");
    if (!(camera.fovDegrees >= 1.0f && camera.fovDegrees <= 170.0f))
        throw Error("camera: the angle is " + std::to_string(camera.fovDegrees) +
                    " degrees; 1 to 170 is possible");
}

/// Any direction across `forward` when `up` has none: looking straight down is allowed.
Vec3 rightOf(const Vec3& forward, const Vec3& up) {
    Vec3 right = forward.cross(up);
    if (right.norm() < 1e-5f * up.norm() || up.norm() == 0.0f)
        right = forward.cross(std::abs(forward.z()) < 0.9f ? Vec3(0, 0, -1) : Vec3(0, 1, 0));
    return right.normalized();
}

Mat4 clipMatrix(const View& v) {
    Mat4 m = Mat4::Zero();
    m.block<1, 3>(0, 0) = v.right.transpose() / (v.tanHalf * v.aspect());
    m.block<1, 3>(1, 0) = v.up.transpose() / v.tanHalf;
    const float a = (v.far + v.near) / (v.far - v.near);
    const float b = -2.0f * v.far * v.near / (v.far - v.near);
    m.block<1, 3>(2, 0) = v.forward.transpose() * a;
    m.block<1, 3>(3, 0) = v.forward.transpose();
    m.col(3) = -(m.leftCols<3>() * v.eye);
    m(2, 3) += b;
    return m;
}

}  // namespace

Projected View::project(const Vec3& point) const {
    const Eigen::Vector4f clip = worldToClip * point.homogeneous();
    Projected p;
    p.distance = clip.w();
    if (p.distance < near) return p;
    p.x = (clip.x() / clip.w() * 0.5f + 0.5f) * static_cast<float>(width);
    p.y = (clip.y() / clip.w() * 0.5f + 0.5f) * static_cast<float>(height);
    p.z = clip.z() / clip.w();
    return p;
}

View makeView(const Camera& camera, int width, int height) {
    requireCamera(camera);
    View v;
    v.width = width;
    v.height = height;
    v.eye = camera.from;
    v.focus = (camera.lookAt - camera.from).norm();
    v.forward = (camera.lookAt - camera.from) / v.focus;
    v.right = rightOf(v.forward, camera.up);
    v.up = v.right.cross(v.forward);
    // In double and rounded: libm's last bit, which differs between CPUs, does not come through.
    v.tanHalf = static_cast<float>(std::tan(double{camera.fovDegrees} * std::numbers::pi / 360.0));
    v.near = 0.02f * v.focus;
    v.far = 300.0f * v.focus;
    v.worldToClip = clipMatrix(v);
    return v;
}

}  // namespace render
