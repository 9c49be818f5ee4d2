#include "engine/forces/airfoil.h"

#include "engine/base/trigonometry.h"
#include "engine/dynamics/bodies.h"

namespace engine {
namespace {

/// 0: attached. 1: stalled; always 1 for air from behind.
double stalledShare(const Airfoil& airfoil, double cosAttack, double sinAttack) {
    if (cosAttack <= 0.0) return 1.0;
    const double beyond = std::abs(sinAttack) - sine(airfoil.stall);
    const double x = clamped(beyond / Airfoil::kStallWidth, 0.0, 1.0);
    return airfoil.stall > 0.0 ? x * x * (3.0 - 2.0 * x) : 1.0;
}

}  // namespace

AirfoilCoefficients coefficientsOf(const Airfoil& airfoil, double cosAttack, double sinAttack) {
    const double stalled = stalledShare(airfoil, cosAttack, sinAttack);
    const double attached = 1.0 - stalled;
    const double lift = airfoil.liftSlope * sinAttack;
    return {attached * lift + stalled * airfoil.plateDrag * sinAttack * cosAttack,
            airfoil.profileDrag + attached * lift * lift / (kPi * airfoil.aspect) +
                stalled * airfoil.plateDrag * sinAttack * sinAttack};
}

void addLoads(const Airfoil& airfoil, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment&, std::span<Load> loads) {
    for (const BodyId id : on) {
        if (!bodies.isAwake(id.index)) continue;
        const Quat& q = bodies.poses[id.index].rotation;
        const Velocity& v = bodies.velocities[id.index];
        const Vec3 arm = q * airfoil.at, chord = q * airfoil.chord, normal = q * airfoil.normal;
        const Vec3 air = airfoil.wind - v.linear - v.angular.cross(arm);
        const double against = -air.dot(chord), up = air.dot(normal);
        const double speed = std::sqrt(against * against + up * up);
        if (speed == 0.0) continue;
        const double cosAttack = against / speed, sinAttack = up / speed;
        const AirfoilCoefficients c = coefficientsOf(airfoil, cosAttack, sinAttack);
        const Vec3 across = sinAttack * chord + cosAttack * normal;
        const Vec3 along = sinAttack * normal - cosAttack * chord;
        const double pressure = 0.5 * airfoil.density * speed * speed * airfoil.area;
        const Vec3 force = pressure * (c.lift * across + c.drag * along);
        loads[id.index].force += force;
        loads[id.index].torque += arm.cross(force);
    }
}

}  // namespace engine
