#include "engine/forces/spring_force.h"

#include "engine/constraints/soft.h"
#include "engine/dynamics/bodies.h"

namespace engine {
namespace {

struct SpringEnd {
    Vec3 arm, point, velocity;

    SpringEnd(const Bodies& bodies, BodyId id, const Vec3& anchor)
        : arm(bodies.poses[id.index].rotation * anchor),
          point(bodies.poses[id.index].position + arm),
          velocity(bodies.velocities[id.index].linear +
                   bodies.velocities[id.index].angular.cross(arm)) {}
    /// The change of the end's velocity along n per unit of impulse along n, 1/kg.
    double ease(const Bodies& bodies, BodyId id, const Vec3& n) const {
        const InverseMass& m = bodies.inverseMasses[id.index];
        const Vec3 turn = arm.cross(n);
        return m.linear + turn.dot(m.angular * turn);
    }
};

bool isThere(std::span<const BodyId> on, const Bodies& bodies) {
    return on.size() == 2 && bodies.present[on[0].index] && bodies.present[on[1].index];
}

}  // namespace

void addLoads(const SpringForce& spring, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads) {
    if (!isThere(on, bodies)) return;
    const SpringEnd a(bodies, on[0], spring.anchorA), b(bodies, on[1], spring.anchorB);
    const Vec3 d = b.point - a.point;
    const double length = d.norm(), h = now.h;
    if (length == 0.0) return;  // no direction
    const Vec3 n = d / length;
    const double ease = now.springs[on[0].index] * a.ease(bodies, on[0], n) +
                        now.springs[on[1].index] * b.ease(bodies, on[1], n);
    if (ease == 0.0) return;
    const SoftRate rate =
        softRate(h * h * spring.stiffness * ease, h * spring.damping * ease, Springs::symplectic);
    const double before = n.dot(b.velocity - a.velocity);
    const double after = rate.kept * ((1.0 - rate.lag) * before - rate.pull * (length - spring.length) / h);
    const Vec3 force = (before - after) / (ease * h) * n;
    loads[on[0].index].force += force;
    loads[on[0].index].torque += a.arm.cross(force);
    loads[on[1].index].force -= force;
    loads[on[1].index].torque -= b.arm.cross(force);
}

double potentialOf(const SpringForce& spring, std::span<const BodyId> on, const Bodies& bodies) {
    if (!isThere(on, bodies)) return 0.0;
    const SpringEnd a(bodies, on[0], spring.anchorA), b(bodies, on[1], spring.anchorB);
    const Vec3 d = b.point - a.point;
    const double length = d.norm(), h = bodies.spans[bodies.movable(on[0].index, on[1].index)];
    const double rate = length > 0.0 ? d.dot(b.velocity - a.velocity) / length : 0.0;
    const double stretch = length - spring.length - 0.5 * h * rate;
    return 0.5 * spring.stiffness * stretch * stretch;
}

}  // namespace engine
