#include "engine/dynamics/energy.h"

namespace engine {
namespace {

Vec3 spinMomentum(const BodyMass& mass, const Quat& q, const Vec3& spin) {
    return q * Vec3(mass.inertia * Vec3(q.conjugate() * spin));
}

}  // namespace

double kineticEnergy(const BodyMass& mass, const Quat& rotation, const Velocity& v) {
    return 0.5 * (mass.mass * v.linear.squaredNorm() +
                  v.angular.dot(spinMomentum(mass, rotation, v.angular)));
}

Energy energyOf(const Bodies& bodies, const Vec3& gravity, double h) {
    Energy e;
    for (int i = 0; i < bodies.count(); ++i) {
        if (!bodies.isDynamic(i)) continue;
        const double m = bodies.masses[i].mass;
        const Velocity& v = bodies.velocities[i];
        e.potential -= m * gravity.dot(bodies.poses[i].position - 0.5 * h * v.linear);
        if (bodies.isStill(i)) continue;
        e.kinetic += kineticEnergy(bodies.masses[i], bodies.poses[i].rotation, v);
    }
    return e;
}

Momentum momentumOf(const Bodies& bodies) {
    Momentum sum;
    for (int i = 0; i < bodies.count(); ++i) {
        if (!bodies.isDynamic(i)) continue;
        const Vec3 p = bodies.masses[i].mass * bodies.velocities[i].linear;
        sum.linear += p;
        sum.angular += bodies.poses[i].position.cross(p) +
                       spinMomentum(bodies.masses[i], bodies.poses[i].rotation,
                                    bodies.velocities[i].angular);
    }
    return sum;
}

}  // namespace engine
