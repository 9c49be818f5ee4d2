/// MuJoCo's axes, z up, in this engine's, y up: (x, y, z) -> (x, z, -y). World axes and those of
/// every body are turned alike, so that what lies along a body's z there lies along its y here,
/// like capsules and cylinders do.
#pragma once
#include "demos/mjcf/attributes.h"

namespace demos::mjcf {

using engine::Mat3;
using engine::Pose;

inline Vec3 yUp(const Vec3& v) { return {v.x(), v.z(), -v.y()}; }
inline Quat yUp(const Quat& q) { return {q.w(), q.x(), q.z(), -q.y()}; }
/// Of lengths along the axes.
inline Vec3 yUpSizes(const Vec3& v) { return {v.x(), v.z(), v.y()}; }
/// R M R^T
Mat3 yUp(const Mat3& inertia);

/// How <compiler> has angles be written.
struct AngleRules {
    bool degrees = true;
    std::string eulerSequence =
        "xyz";  // small: about axes that turn along; large: about fixed ones

    double radians(double angle) const;
};

/// The turn that brings `from` to `to` by the short way, both of any length but zero.
Quat shortestTurn(const Vec3& from, const Vec3& to);

/// quat, axisangle, xyaxes, zaxis or euler; none: no turn. In axes with y up.
Quat readOrientation(Attributes& attributes, const AngleRules& rules);
/// pos and orientation, likewise.
Pose readPose(Attributes& attributes, const AngleRules& rules);

/// The pose in world axes of what is at `inner` in the axes of `outer`.
inline Pose operator*(const Pose& outer, const Pose& inner) {
    return {outer.toWorld(inner.position), (outer.rotation * inner.rotation).normalized()};
}

}  // namespace demos::mjcf
