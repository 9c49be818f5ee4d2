/// The vector types: Eigen's fixed-size types, in double.
/// Only + - * / and sqrt appear below this line: they round the same on every machine.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/Cholesky>
#include <cmath>

namespace engine {

using Vec2 = Eigen::Vector2d;  // x, y
using Vec3 = Eigen::Vector3d;  // x, y, z; right-handed
using Vec4 = Eigen::Vector4d;  // four values
using Mat2 = Eigen::Matrix2d;     // 2 x 2
using Mat3 = Eigen::Matrix3d;  // inertia, rotation
using Mat4 = Eigen::Matrix4d;     // 4 x 4
using Quat = Eigen::Quaterniond;  // a rotation, of length 1; constructed as (w, x, y, z)

/// Ties and NaNs are defined: a when the two are equal, b when a is NaN.
template <class Value>
Value smaller(Value a, Value b) {
    return a <= b ? a : b;
}
/// The larger one, with the same rules.
template <class Value>
Value larger(Value a, Value b) {
    return a >= b ? a : b;
}
/// x, limited to [low, high].
template <class Value>
Value clamped(Value x, Value low, Value high) {
    return smaller(larger(x, low), high);
}

/// The cross product as a matrix: crossMatrix(a) b = a x b.
inline Mat3 crossMatrix(const Vec3& a) {
    Mat3 m;
    m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    return m;
}

/// Two unit vectors that complete the unit vector n to a right-handed frame (n, t1, t2).
/// The helper is the axis least aligned with n, which avoids cancellation.
inline void tangents(const Vec3& n, Vec3& t1, Vec3& t2) {
    const double x = std::abs(n.x()), y = std::abs(n.y()), z = std::abs(n.z());
    const Vec3 helper = x <= y && x <= z ? Vec3(Vec3::UnitX())
                        : y <= z         ? Vec3(Vec3::UnitY())
                                         : Vec3(Vec3::UnitZ());
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
