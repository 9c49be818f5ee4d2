#include "engine/base/trigonometry.h"

namespace engine {
namespace {

/// x = k pi/2 + r with |r| <= pi/4. pi/2 is subtracted in three pieces, the first two of 33 bits, so that k
/// times them is exact (Cody and Waite).
struct Reduced {
    int quadrant;
    double r;
};

Reduced reduce(double x) {
    constexpr double kHigh = 1.57079632673412561417e+00;
    constexpr double kMiddle = 6.07710050630396597660e-11;
    constexpr double kLow = 2.02226624879595063154e-21;
    const double k = std::floor(x * (2.0 / kPi) + 0.5);
    const double r = ((x - k * kHigh) - k * kMiddle) - k * kLow;
    const double turns = std::floor(k / 4.0);
    const double quadrant = k - 4.0 * turns;  // not a number for an x that is not finite
    return {quadrant > 0.0 ? static_cast<int>(quadrant) : 0, r};
}

/// Taylor series; for |r| <= pi/4 the first omitted term is below 1e-18.
double sineSeries(double r) {
    const double s = r * r;
    double sum = 0.0;
    for (const double divisor : {16.0 * 17.0, 14.0 * 15.0, 12.0 * 13.0, 10.0 * 11.0, 8.0 * 9.0,
                                 6.0 * 7.0, 4.0 * 5.0, 2.0 * 3.0})
        sum = -(s / divisor) * (1.0 + sum);
    return r + r * sum;
}

double cosineSeries(double r) {
    const double s = r * r;
    double sum = 0.0;
    for (const double divisor : {17.0 * 18.0, 15.0 * 16.0, 13.0 * 14.0, 11.0 * 12.0, 9.0 * 10.0,
                                 7.0 * 8.0, 5.0 * 6.0, 3.0 * 4.0, 1.0 * 2.0})
        sum = -(s / divisor) * (1.0 + sum);
    return 1.0 + sum;
}

/// atan(z) for |z| <= 1: halved twice by atan(z) = 2 atan(z / (1 + sqrt(1 + z^2))), then the Taylor series.
double arctangentOfRatio(double z) {
    for (int halving = 0; halving < 2; ++halving) z = z / (1.0 + std::sqrt(1.0 + z * z));
    const double s = z * z;
    double sum = 0.0;
    for (int n = 25; n >= 1; n -= 2) sum = 1.0 / n - s * sum;
    return 4.0 * z * sum;
}

}  // namespace

double sine(double radians) {
    const Reduced x = reduce(radians);
    const double value = x.quadrant % 2 == 0 ? sineSeries(x.r) : cosineSeries(x.r);
    return x.quadrant < 2 ? value : -value;
}

double cosine(double radians) {
    const Reduced x = reduce(radians);
    const double value = x.quadrant % 2 == 0 ? cosineSeries(x.r) : sineSeries(x.r);
    return x.quadrant == 1 || x.quadrant == 2 ? -value : value;
}

double arctangent(double y, double x) {
    const double across = std::abs(x), up = std::abs(y);
    if (across == 0.0 && up == 0.0) return 0.0;
    double angle = up <= across ? arctangentOfRatio(up / across)
                                : kPi / 2.0 - arctangentOfRatio(across / up);
    if (x < 0.0) angle = kPi - angle;
    return y < 0.0 ? -angle : angle;
}

Quat turnAbout(const Vec3& axis, double radians) {
    const Vec3 v = axis * sine(0.5 * radians);
    return Quat(cosine(0.5 * radians), v.x(), v.y(), v.z());
}

Quat turnAboutXyz(const Vec3& radians) {
    return turnAbout(Vec3::UnitZ(), radians.z()) * turnAbout(Vec3::UnitY(), radians.y()) *
           turnAbout(Vec3::UnitX(), radians.x());
}

}  // namespace engine
