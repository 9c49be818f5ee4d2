/// A box for tests along separating axes.
#pragma once
#include "engine/base/math.h"
#include "engine/shape.h"

namespace engine {

struct OrientedBox {
    Mat3 axes;  // columns
    Vec3 centre, half;

    OrientedBox(const Shape& shape, const Pose& pose)
        : axes(pose.rotation.toRotationMatrix()), centre(pose.position), half(shape.halfSize) {}
    /// Half its extent along the unit vector n.
    double extent(const Vec3& n) const { return (axes.transpose() * n).cwiseAbs().dot(half); }
};

}  // namespace engine
