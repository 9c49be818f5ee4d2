/// Sine, cosine and arctangent for loading scenes: those of the C library differ in the last bit
/// between processors, so a scene placed with them would start from different bits. Accurate to
/// 2e-15 for |x| up to 1e5 (tests/engine/base/trigonometry_test.cpp).
#pragma once
#include "engine/base/math.h"

namespace engine {

constexpr double kPi = 3.14159265358979323846;

double sine(double radians);
double cosine(double radians);
/// Angle of the vector (x, y), in (-pi, pi]; 0 for the zero vector.
double arctangent(double y, double x);

/// Rotation by `radians` about the unit vector `axis`.
Quat turnAbout(const Vec3& axis, double radians);
/// Rotation about the fixed x axis first, then y, then z.
Quat turnAboutXyz(const Vec3& radians);

inline double radians(double degrees) { return degrees * (kPi / 180.0); }

}  // namespace engine
