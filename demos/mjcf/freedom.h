/// From a force along a coordinate to what acts along it here.
#pragma once
#include "demos/mjcf/affine_force.h"
#include "demos/mjcf/attributes.h"
#include "engine/joint.h"

namespace demos::mjcf {

/// Of springs, dampers, friction and rotors.
inline constexpr Range kStrength{0.0, 1e12};

/// Adds the spring or tendon's own numbers of `attributes` (stiffness, damping, frictionloss, armature)
/// and `force`; `rest` and `ref`: where the spring is at rest, and what MuJoCo's coordinate is where
/// `freedom` counts 0. What cannot be held is noted.
void actAlong(Attributes& attributes, AffineForce force, double rest, double ref,
              engine::Freedom& freedom);

/// Whether a range counts: `limited`, or that there is a range.
bool isLimited(Attributes& attributes, const char* limited, const char* range, bool autoLimits);

}  // namespace demos::mjcf
