#include "demos/scene/expression_functions.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "demos/scene/expression.h"
#include "demos/scene/split_mix.h"
#include "demos/text/complaints.h"
#include "engine/base/trigonometry.h"

namespace demos {
namespace expressions {
namespace {

constexpr double kLargestAngle = 1e5;  // rad; beyond it engine::sine loses digits
constexpr double kLargestExponent = 1000.0;

double angle(double radians) {
    if (std::fabs(radians) <= kLargestAngle) return radians;
    throw Undefined("an angle of " + numberText(radians) +
                    " rad; it should be from -100000 to 100000 rad");
}

double unit(double x, const char* name) {
    if (std::fabs(x) <= 1.0) return x;
    throw Undefined(std::string(name) + "(" + numberText(x) + "); it should be from -1 to 1");
}

}  // namespace

double add(double a, double b) { return a + b; }
double subtract(double a, double b) { return a - b; }
double multiply(double a, double b) { return a * b; }
double minus(double x) { return -x; }
double plus(double x) { return x; }

double divide(double a, double b) {
    if (b == 0.0) throw Undefined("a division by zero");
    return a / b;
}

double power(double base, double exponent) {
    if (exponent != std::floor(exponent) || std::fabs(exponent) > kLargestExponent)
        throw Undefined("an exponent of " + numberText(exponent) +
                        "; it should be a whole number from -1000 to 1000, or use sqrt()");
    double square = base, result = 1.0;
    for (int rest = static_cast<int>(std::fabs(exponent)); rest > 0; rest /= 2) {
        if (rest % 2 == 1) result *= square;
        square *= square;
    }
    return exponent < 0.0 ? divide(1.0, result) : result;
}

double sine(double radians) { return engine::sine(angle(radians)); }
double cosine(double radians) { return engine::cosine(angle(radians)); }
double tangent(double radians) { return divide(sine(radians), cosine(radians)); }

double arcsine(double x) {
    return engine::arctangent(unit(x, "asin"), std::sqrt((1.0 - x) * (1.0 + x)));
}

double arccosine(double x) {
    return engine::arctangent(std::sqrt((1.0 - x) * (1.0 + x)), unit(x, "acos"));
}

double arctangent(double x) { return engine::arctangent(x, 1.0); }
double arctangent2(double y, double x) { return engine::arctangent(y, x); }

double squareRoot(double x) {
    if (x < 0.0) throw Undefined("sqrt(" + numberText(x) + "); it should not be below 0");
    return std::sqrt(x);
}

double magnitude(double x) { return std::fabs(x); }
double below(double x) { return std::floor(x); }
double above(double x) { return std::ceil(x); }

double nearestWhole(double x) {
    const double whole = std::floor(std::fabs(x));
    const double rounded = std::fabs(x) - whole >= 0.5 ? whole + 1.0 : whole;
    return x < 0.0 ? -rounded : rounded;
}

double modulo(double a, double b) {
    if (b == 0.0) throw Undefined("a division by zero");
    const double rest = std::fmod(a, b);  // exact everywhere
    return rest != 0.0 && (rest < 0.0) != (b < 0.0) ? rest + b : rest;
}

double smallest(const double* numbers, int count) {
    double least = numbers[0];
    for (int i = 1; i < count; ++i) least = numbers[i] < least ? numbers[i] : least;
    return least;
}

double largest(const double* numbers, int count) {
    double most = numbers[0];
    for (int i = 1; i < count; ++i) most = numbers[i] > most ? numbers[i] : most;
    return most;
}

}  // namespace expressions

double hashed(const double* numbers, int count) {
    std::uint64_t bits = 0;
    for (int i = 0; i < count; ++i)  // -0 becomes +0
        bits = SplitMix64(bits ^ std::bit_cast<std::uint64_t>(numbers[i] + 0.0)).next();
    return static_cast<double>(bits >> 11) / 9007199254740992.0;
}

}  // namespace demos
