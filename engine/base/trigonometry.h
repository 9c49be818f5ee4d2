/// Sine, cosine and arctangent for the time of loading: the C library's differ in their last bit
/// from one processor to the next, and a scene placed by them would start from other bits.
/// Good to 2e-15 for |x| up to 1e5 (tests/engine/base/trigonometry_test.cpp).
#pragma once
#include "engine/base/math.h"

namespace engine {

constexpr double kPi = 3.14159265358979323846;

double sine(double radians);
double cosine(double radians);
/// Angle of the vector (x, y), in (-pi, pi]; 0 for the zero vector.
double arctangent(double y, double x);

/// Turn by `radians` about the unit vector `axis`.
Quat turnAbout(const Vec3& axis, double radians);
/// About the fixed x axis first, then y, then z.
Quat turnAboutXyz(const Vec3& radians);

inline double radians(double degrees) { return degrees * (kPi / 180.0); }

}  // namespace engine
