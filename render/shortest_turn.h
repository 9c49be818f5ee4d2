/// The shortest rotation from one direction to another.
#pragma once
#include <Eigen/Geometry>
#include <cmath>

namespace render {

/// q = (cos(phi / 2), sin(phi / 2) n) = (s / 2, (a x b) / s), s = sqrt(2 (1 + a . b)), for the two
/// unit vectors. For opposite vectors: half a turn about any perpendicular axis. Equal to Eigen's
/// Quaternion::FromTwoVectors to the bit, except for that axis, for which Eigen uses a singular
/// value decomposition that takes long to compile.
template <class Real>
Eigen::Quaternion<Real> shortestTurn(const Eigen::Matrix<Real, 3, 1>& from,
                                     const Eigen::Matrix<Real, 3, 1>& to) {
    using Direction = Eigen::Matrix<Real, 3, 1>;
    const Direction a = from.normalized(), b = to.normalized();
    const Real c = b.dot(a);
    if (c < Real(-1) + Eigen::NumTraits<Real>::dummy_precision()) {
        const Direction other = std::abs(a.z()) < Real(0.9) ? Direction(0, 0, 1) : Direction(1, 0, 0);
        const Direction across = (other - a.dot(other) * a).normalized();
        return {Real(0), across.x(), across.y(), across.z()};
    }
    const Real s = std::sqrt((Real(1) + c) * Real(2));
    const Direction axis = a.cross(b) * (Real(1) / s);
    return {s * Real(0.5), axis.x(), axis.y(), axis.z()};
}

}  // namespace render
