/// The functions and operators of expressions. Each gives the same bits on every machine, or
/// throws Undefined.
#pragma once
#include <stdexcept>

namespace demos {

/// The result is undefined. The message is the end of a sentence.
struct Undefined : std::runtime_error {
    using std::runtime_error::runtime_error;
};

namespace expressions {

double add(double a, double b);
double subtract(double a, double b);
double multiply(double a, double b);
double divide(double a, double b);
/// Whole exponents only, by multiplication.
double power(double base, double exponent);
double minus(double x);
double plus(double x);

double sine(double radians);
double cosine(double radians);
double tangent(double radians);
double arcsine(double x);
double arccosine(double x);
double arctangent(double x);
double arctangent2(double y, double x);
double squareRoot(double x);
double magnitude(double x);
double below(double x);
double above(double x);
/// Rounds halves away from zero.
double nearestWhole(double x);
/// a - b floor(a / b), exactly; it has the sign of b.
double modulo(double a, double b);
double smallest(const double* numbers, int count);
double largest(const double* numbers, int count);

}  // namespace expressions
}  // namespace demos
