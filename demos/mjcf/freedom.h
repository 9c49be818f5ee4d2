/// Converts a force along a coordinate to the spring, motor and rotor of engine::Freedom.
#pragma once
#include "demos/mjcf/affine_force.h"
#include "demos/mjcf/attributes.h"
#include "engine/joint.h"

namespace demos::mjcf {

/// For springs, dampers, friction and rotors.
inline constexpr Range kStrength{0.0, 1e12};

/// Adds stiffness, damping, frictionloss and armature from `attributes` of a joint or tendon, and
/// `force`. `rest`: where the spring is at rest; `ref`: MuJoCo's coordinate where that of `freedom`
/// is 0. What cannot be represented is noted.
void actAlong(Attributes& attributes, AffineForce force, double rest, double ref,
              engine::Freedom& freedom);

/// Whether a range counts: by `limited`, or with autolimits because it is given.
bool isLimited(Attributes& attributes, const char* limited, const char* range, bool autoLimits);

}  // namespace demos::mjcf
