#include "engine/forces/constant_force.h"

#include "engine/dynamics/bodies.h"

namespace engine {

void addLoads(const ConstantForce& force, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment&, std::span<Load> loads) {
    for (const BodyId id : on) {
        if (!bodies.isAwake(id.index)) continue;
        const Quat& q = bodies.poses[id.index].rotation;
        const Vec3 f = force.turns ? Vec3(q * force.force) : force.force;
        const Vec3 t = force.turns ? Vec3(q * force.torque) : force.torque;
        const Vec3 arm = q * force.at;
        loads[id.index].force += f;
        loads[id.index].torque += t + arm.cross(f);
    }
}

}  // namespace engine
