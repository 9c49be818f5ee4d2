/// Two doubles side by side. Every operation does with each of them what it would do with it alone. So a text
/// written for any `Real` gives two bodies the same bits as one after the other, in little more than the time
/// of one: their divisions and square roots do not wait for each other.
#pragma once
#include "engine/base/math.h"

namespace engine {

struct Two {
    using Pair = double __attribute__((vector_size(16)));

    Two() = default;
    Two(double both) : v{both, both} {}  // implicit, as 0.0 is a double
    Two(double first, double second) : v{first, second} {}
    double operator[](int i) const { return v[i]; }

    Two& operator+=(const Two& b) { return v += b.v, *this; }
    Two& operator-=(const Two& b) { return v -= b.v, *this; }
    Two& operator*=(const Two& b) { return v *= b.v, *this; }
    Two& operator/=(const Two& b) { return v /= b.v, *this; }

    Pair v;
};

inline Two operator+(Two a, const Two& b) { return a += b; }
inline Two operator-(Two a, const Two& b) { return a -= b; }
inline Two operator*(Two a, const Two& b) { return a *= b; }
inline Two operator/(Two a, const Two& b) { return a /= b; }
inline Two operator-(Two a) { return a.v = -a.v, a; }
inline Two sqrt(const Two& a) { return {std::sqrt(a[0]), std::sqrt(a[1])}; }
/// Both; what is compared here is not NaN.
inline bool operator>(const Two& a, const Two& b) { return a[0] > b[0] && a[1] > b[1]; }

}  // namespace engine

template <>
struct Eigen::NumTraits<engine::Two> : Eigen::GenericNumTraits<engine::Two> {
    enum { RequireInitialization = 0, ReadCost = 1, AddCost = 1, MulCost = 1 };
};

namespace engine {

template <class Real>
using Vec3Of = Eigen::Matrix<Real, 3, 1>;
template <class Real>
using Mat3Of = Eigen::Matrix<Real, 3, 3>;
template <class Real>
using QuatOf = Eigen::Quaternion<Real>;

template <int Rows, int Columns>
Eigen::Matrix<Two, Rows, Columns> sideBySide(const Eigen::Matrix<double, Rows, Columns>& a,
                                           const Eigen::Matrix<double, Rows, Columns>& b) {
    Eigen::Matrix<Two, Rows, Columns> both;
    for (int i = 0; i < both.size(); ++i) both(i) = Two(a(i), b(i));
    return both;
}
inline QuatOf<Two> sideBySide(const Quat& a, const Quat& b) {
    return QuatOf<Two>(sideBySide(a.coeffs(), b.coeffs()));
}

inline double partOf(double a, int) { return a; }
inline double partOf(const Two& a, int i) { return a[i]; }
template <class Real>
Vec3 partOf(const Vec3Of<Real>& a, int i) {
    return {partOf(a.x(), i), partOf(a.y(), i), partOf(a.z(), i)};
}
template <class Real>
Quat partOf(const QuatOf<Real>& a, int i) {
    return {partOf(a.w(), i), partOf(a.x(), i), partOf(a.y(), i), partOf(a.z(), i)};
}

}  // namespace engine
