/// Ranges of numbers that several tables of a scene have.
#pragma once
#include "demos/scene/catalog.h"

namespace demos {

inline constexpr Range kMeters{-1e5, 1e5, "m"};  // positions and translations
inline constexpr Range kSize{1e-3, 1e3, "m"};
inline constexpr Range kDegrees{-1e6, 1e6, "deg"};
inline constexpr Range kSpeed{-1e4, 1e4, "m/s"};
inline constexpr Range kSpin{-1e4, 1e4, "rad/s"};
inline constexpr Range kDensity{1e-3, 1e6, "kg/m^3"};  // of bodies and their parts

}  // namespace demos
