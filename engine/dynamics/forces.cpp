#include "engine/dynamics/forces.h"

namespace engine {

void applyForces(Bodies& bodies, const Vec3& gravity, std::span<const Load> field) {
    for (const int i : bodies.active) {
        if (!bodies.isActing(i)) continue;
        Load load = bodies.loads[i];
        if (!field.empty()) {
            load.force += field[i].force;
            load.torque += field[i].torque;
        }
        const InverseMass& m = bodies.inverseMasses[i];
        bodies.accelerations[i] = {gravity + m.linear * load.force, m.angular * load.torque};
    }
}

}  // namespace engine
