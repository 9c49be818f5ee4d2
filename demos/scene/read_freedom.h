/// What acts along a coordinate that a joint leaves free: limits, motor, spring, rotor.
#pragma once
#include "demos/scene/keys.h"
#include "engine/joint.h"

namespace demos {

/// m and N, or rad and N m.
enum class Way { along, about };

/// [low, high], in m or deg; nothing where it is not given.
std::optional<engine::Limits> readLimits(Keys& keys, const char* key, Way way);
/// { speed, max }; without max it is never too weak.
std::optional<engine::Motor> readMotor(Keys& keys, const char* key, Way way);
/// { hz, damping }
std::optional<engine::Spring> readSpring(Keys& keys, const char* key);
/// { hz, damping, rest } or rest_deg, into `freedom`.
void readRestingSpring(Keys& keys, const char* key, Way way, engine::Freedom& freedom);

/// Of a rotor; kg m^2, or kg along a way.
std::optional<double> readInertia(Keys& keys, const char* key, Way way);

/// Of a six-dof joint: "free", "locked" or { limits, motor, spring, inertia }.
engine::Freedom readFreedom(Keys& keys, const char* key, Way way);

}  // namespace demos
