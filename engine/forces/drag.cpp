#include "engine/forces/drag.h"

#include "engine/dynamics/bodies.h"

namespace engine {

double largestDrag(const Bodies& bodies, int body, double h) {
    return 1.0 / (h * bodies.inverseMasses[body].linear);
}

double largestSpinDrag(const Bodies& bodies, int body, double h) {
    return 1.0 / (h * bodies.inverseMasses[body].angular.trace());
}

void addLoads(const Drag& drag, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads) {
    for (const BodyId id : on) {
        if (!bodies.isAwake(id.index)) continue;
        const Velocity& v = bodies.velocities[id.index];
        const double c = smaller(drag.linear, largestDrag(bodies, id.index, now.h));
        const double k = smaller(drag.angular, largestSpinDrag(bodies, id.index, now.h));
        loads[id.index].force -= c * v.linear;
        loads[id.index].torque -= k * v.angular;
    }
}

}  // namespace engine
