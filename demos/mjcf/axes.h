/// From MuJoCo's axes, z up, to this engine's, y up: (x, y, z) -> (x, z, -y). World axes and those
/// of every body are turned alike, so that a body's z there is its y here, which suits capsules and
/// cylinders.
#pragma once
#include "demos/mjcf/attributes.h"

namespace demos::mjcf {

using engine::Mat3;
using engine::Pose;

inline Vec3 yUp(const Vec3& v) { return {v.x(), v.z(), -v.y()}; }
inline Quat yUp(const Quat& q) { return {q.w(), q.x(), q.z(), -q.y()}; }
/// For lengths along the axes.
inline Vec3 yUpSizes(const Vec3& v) { return {v.x(), v.z(), v.y()}; }
/// R M R^T
Mat3 yUp(const Mat3& inertia);

/// How angles are written, by <compiler>.
struct AngleRules {
    bool degrees = true;
    std::string eulerSequence =
        "xyz";  // lower case: about axes that rotate with the body; upper case: about fixed axes

    double radians(double angle) const;
};

/// The shortest rotation from `from` to `to`; neither may be zero.
Quat shortestTurn(const Vec3& from, const Vec3& to);

/// quat, axisangle, xyaxes, zaxis or euler, or identity. In axes with y up.
Quat readOrientation(Attributes& attributes, const AngleRules& rules);
/// pos and orientation, in axes with y up.
Pose readPose(Attributes& attributes, const AngleRules& rules);

/// The pose in world axes of an object at `inner` in the axes of `outer`.
inline Pose operator*(const Pose& outer, const Pose& inner) {
    return {outer.toWorld(inner.position), (outer.rotation * inner.rotation).normalized()};
}

}  // namespace demos::mjcf
