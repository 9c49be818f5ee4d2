#include "engine/dynamics/energy.h"

namespace engine {
namespace {

Vec3 spinMomentum(const Bodies& bodies, int i) {
    const Quat& q = bodies.poses[i].rotation;
    const Vec3 local = q.conjugate() * bodies.velocities[i].angular;
    return q * Vec3(bodies.masses[i].inertia * local);
}

}  // namespace

double kineticEnergyOf(const Bodies& bodies, int i) {
    const Velocity& v = bodies.velocities[i];
    return 0.5 * (bodies.masses[i].mass * v.linear.squaredNorm() +
                  v.angular.dot(spinMomentum(bodies, i)));
}

Vec3 restMomentOf(const Bodies& bodies) {
    Vec3 sum = Vec3::Zero();
    auto active = bodies.active.begin();
    for (int i = 0; i < bodies.count(); ++i) {
        const bool isActive = active != bodies.active.end() && *active == i;
        if (isActive) ++active;
        if (!isActive && bodies.isDynamic(i)) sum += bodies.masses[i].mass * bodies.poses[i].position;
    }
    return sum;
}

void sumResting(Bodies& bodies) {
    if (bodies.restStale) bodies.restMoment = restMomentOf(bodies);
    bodies.restStale = false;
}

Energy energyOf(const Bodies& bodies, const Vec3& gravity) {
    Energy e;
    e.potential = -gravity.dot(bodies.restStale ? restMomentOf(bodies) : bodies.restMoment);
    for (const int i : bodies.active) {
        if (!bodies.isDynamic(i)) continue;
        const Vec3& v = bodies.velocities[i].linear;
        e.potential -= bodies.masses[i].mass *
                       gravity.dot(bodies.poses[i].position - 0.5 * bodies.spans[i] * v);
        if (!bodies.isStill(i)) e.kinetic += kineticEnergyOf(bodies, i);
    }
    return e;
}

Momentum momentumOf(const Bodies& bodies) {
    Momentum sum;
    for (int i = 0; i < bodies.count(); ++i) {
        if (!bodies.isDynamic(i)) continue;
        const Vec3 p = bodies.masses[i].mass * bodies.velocities[i].linear;
        sum.linear += p;
        sum.angular += bodies.poses[i].position.cross(p) + spinMomentum(bodies, i);
    }
    return sum;
}

}  // namespace engine
