#include "render/mirrored_view.h"

#include <Eigen/LU>

namespace render {
namespace {

/// With the ground as the near clip plane, whose distances are those of the clip space's z.
/// (E. Lengyel: Oblique View Frustum Depth Projection and Clipping)
Eigen::Matrix4f cutAt(const Eigen::Matrix4f& projection, const Eigen::Vector4f& plane) {
    const Eigen::Matrix4d p = projection.cast<double>(), back = p.inverse();
    const Eigen::Vector4d cut = plane.cast<double>(), inClip = back.transpose() * cut;
    const auto sign = [](double x) { return x < 0.0 ? -1.0 : 1.0; };
    const Eigen::Vector4d far = back * Eigen::Vector4d(sign(inClip.x()), sign(inClip.y()), 1, 1);
    Eigen::Matrix4d result = p;
    result.row(2) = 2.0 / cut.dot(far) * cut.transpose() - p.row(3);
    return result.cast<float>();
}

}  // namespace

bool isAbove(const Vec3& point, const Ground& ground) {
    return ground.normal.normalized().dot(point) > ground.offset;
}

View mirroredView(const View& view, const Ground& ground) {
    const Vec3 n = ground.normal.normalized();
    Eigen::Matrix4f mirror = Eigen::Matrix4f::Identity();
    mirror.block<3, 3>(0, 0) -= 2.0f * n * n.transpose();
    mirror.block<3, 1>(0, 3) = 2.0f * ground.offset * n;
    View result = view;
    result.view = view.view * mirror;
    result.eye = view.eye - 2.0f * (n.dot(view.eye) - ground.offset) * n;
    Eigen::Vector4f plane;
    plane << n, -ground.offset;
    result.projection = cutAt(view.projection, result.view.inverse().transpose() * plane);
    return result;
}

}  // namespace render
