/// Limits, motor, spring and rotor of a coordinate that a joint leaves free.
#pragma once
#include "demos/scene/keys.h"
#include "engine/joint.h"

namespace demos {

/// A translation (m and N) or a rotation (rad and N m).
enum class Way { along, about };

/// [low, high], in m or deg; nothing if it is missing.
std::optional<engine::Limits> readLimits(Keys& keys, const char* key, Way way);
/// { speed, max }; without max its strength is unlimited.
std::optional<engine::Motor> readMotor(Keys& keys, const char* key, Way way);
/// { hz, damping }
std::optional<engine::Spring> readSpring(Keys& keys, const char* key);
/// { hz, damping, rest } or rest_deg, into `freedom`.
void readRestingSpring(Keys& keys, const char* key, Way way, engine::Freedom& freedom);

/// Of a rotor; kg m^2, or kg for a translation.
std::optional<double> readInertia(Keys& keys, const char* key, Way way);

/// A coordinate of a six-dof joint: "free", "locked" or { limits, motor, spring, inertia }.
engine::Freedom readFreedom(Keys& keys, const char* key, Way way);

}  // namespace demos
