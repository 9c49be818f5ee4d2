#include "engine/dynamics/rotation.h"

#include <Eigen/LU>

namespace engine {

Vec3 spinAfterGyroscopicTorque(const BodyMass& mass, const Quat& rotation, const Vec3& spin,
                               double h) {
    // f(w) = I (w - w0) + h w x I w, from w = w0:  J = I + h ([w]x I - [I w]x),  w -= J^-1 f
    const Vec3 w = rotation.conjugate() * spin;
    const Vec3 momentum = mass.inertia * w;
    const Vec3 f = h * w.cross(momentum);
    const Mat3 jacobian =
        mass.inertia + h * (crossMatrix(w) * mass.inertia - crossMatrix(momentum));
    return rotation * Vec3(w - jacobian.inverse() * f);
}

namespace {

/// w = R I^-1 R^T L
inline Vec3 spinOf(const Vec3& momentum, const BodyMass& mass, const Quat& rotation) {
    return rotation * Vec3(mass.inverseInertia * Vec3(rotation.conjugate() * momentum));
}

}  // namespace

void turnKeepingMomentum(const BodyMass& mass, double h, Quat& rotation, Vec3& spin) {
    if (mass.isRound) {  // L and w are parallel: w stays
        rotation = cayley(h * spin, rotation);
        return;
    }
    const Vec3 momentum = rotation * Vec3(mass.inertia * Vec3(rotation.conjugate() * spin));
    const Quat half = cayley(0.5 * h * spin, rotation);
    const Vec3 spinHalf = spinOf(momentum, mass, half);
    rotation = cayley(h * spinHalf, rotation);
    spin = spinOf(momentum, mass, rotation);
}

}  // namespace engine
