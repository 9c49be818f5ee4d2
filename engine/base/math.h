/// The vocabulary: Eigen's fixed-size types by the scalar they hold. The world is in double; the
/// solver's text is templated, so that tests can run it in float as well.
/// Only + - * / and sqrt appear below this line: they round the same on every machine.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/Cholesky>
#include <cmath>

namespace engine {

template <class Real>
using Vec2T = Eigen::Matrix<Real, 2, 1>;  // a column of 2
template <class Real>
using Vec3T = Eigen::Matrix<Real, 3, 1>;  // a column of 3
template <class Real>
using Vec4T = Eigen::Matrix<Real, 4, 1>;  // a column of 4
template <class Real>
using Mat2T = Eigen::Matrix<Real, 2, 2>;  // 2 x 2
template <class Real>
using Mat3T = Eigen::Matrix<Real, 3, 3>;  // 3 x 3
template <class Real>
using Mat4T = Eigen::Matrix<Real, 4, 4>;  // 4 x 4
template <class Real>
using QuatT = Eigen::Quaternion<Real>;  // made as (w, x, y, z)

using Vec2 = Vec2T<double>;  // x, y
using Vec3 = Vec3T<double>;  // x, y, z; right-handed
using Vec4 = Vec4T<double>;  // four of a kind
using Mat3 = Mat3T<double>;  // inertia, rotation
using Quat = QuatT<double>;  // a rotation, of length 1

/// Ties and NaNs are defined: a when the two are equal, b when a is not a number.
template <class Real>
Real smaller(Real a, Real b) {
    return a <= b ? a : b;
}
/// The larger one, with the same ties.
template <class Real>
Real larger(Real a, Real b) {
    return a >= b ? a : b;
}
/// x, or the bound it is beyond.
template <class Real>
Real clamped(Real x, Real low, Real high) {
    return smaller(larger(x, low), high);
}

/// The matrix that crosses: crossMatrix(a) b = a x b.
template <class Real>
Mat3T<Real> crossMatrix(const Vec3T<Real>& a) {
    Mat3T<Real> m;
    m << Real(0), -a.z(), a.y(), a.z(), Real(0), -a.x(), -a.y(), a.x(), Real(0);
    return m;
}

/// Two unit vectors that complete the unit vector n to a right-handed frame (n, t1, t2).
/// The axis least along n is the helper, so that nothing cancels.
template <class Real>
void tangents(const Vec3T<Real>& n, Vec3T<Real>& t1, Vec3T<Real>& t2) {
    const Real x = std::abs(n.x()), y = std::abs(n.y()), z = std::abs(n.z());
    const Vec3T<Real> helper = x <= y && x <= z ? Vec3T<Real>(Vec3T<Real>::UnitX())
                               : y <= z         ? Vec3T<Real>(Vec3T<Real>::UnitY())
                                                : Vec3T<Real>(Vec3T<Real>::UnitZ());
    t1 = n.cross(helper).normalized();
    t2 = n.cross(t1);
}

/// Where a body is: x_world = position + rotation * x_local.
struct Pose {
    Vec3 position = Vec3::Zero();    // m, centre of mass
    Quat rotation = Quat::Identity();  // body axes to world axes, of length 1

    /// A point from body axes to world axes (m).
    Vec3 toWorld(const Vec3& local) const { return position + rotation * local; }
    /// A point from world axes to body axes (m).
    Vec3 toLocal(const Vec3& world) const { return rotation.conjugate() * (world - position); }
};

}  // namespace engine
