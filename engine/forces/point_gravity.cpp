#include "engine/forces/point_gravity.h"

#include "engine/dynamics/bodies.h"

namespace engine {
namespace {

double squaredDistance(const PointGravity& gravity, const Vec3& d) {
    return d.squaredNorm() + gravity.softening * gravity.softening;
}

}  // namespace

void addLoads(const PointGravity& gravity, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment&, std::span<Load> loads) {
    for (const BodyId id : on) {
        if (!bodies.isAwake(id.index)) continue;
        const Vec3 d = gravity.centre - bodies.poses[id.index].position;
        const double r2 = squaredDistance(gravity, d);
        if (r2 == 0.0) continue;
        loads[id.index].force +=
            bodies.masses[id.index].mass * gravity.strength / (r2 * std::sqrt(r2)) * d;
    }
}

double potentialOf(const PointGravity& gravity, std::span<const BodyId> on, const Bodies& bodies) {
    double sum = 0.0;
    for (const BodyId id : on) {
        if (!bodies.isDynamic(id.index)) continue;
        const Vec3 d = gravity.centre - bodies.poses[id.index].position;
        const double r2 = squaredDistance(gravity, d);
        if (r2 > 0.0) sum -= bodies.masses[id.index].mass * gravity.strength / std::sqrt(r2);
    }
    return sum;
}

}  // namespace engine
