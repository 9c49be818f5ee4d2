#include "engine/forces/n_body_gravity.h"

#include "engine/dynamics/bodies.h"

namespace engine {
namespace {

/// Calls `visit(i, j, d, r2)` for every pair that does not coincide.
template <class Visit>
void forEachPair(const NBodyGravity& gravity, std::span<const BodyId> on, const Bodies& bodies,
                 Visit visit) {
    for (std::size_t k = 0; k < on.size(); ++k) {
        const int i = on[k].index;
        if (!bodies.isDynamic(i)) continue;
        for (std::size_t l = k + 1; l < on.size(); ++l) {
            const int j = on[l].index;
            if (!bodies.isDynamic(j)) continue;
            const Vec3 d = bodies.poses[j].position - bodies.poses[i].position;
            const double r2 = d.squaredNorm() + gravity.softening * gravity.softening;
            if (r2 > 0.0) visit(i, j, d, r2);
        }
    }
}

}  // namespace

void addLoads(const NBodyGravity& gravity, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment&, std::span<Load> loads) {
    forEachPair(gravity, on, bodies, [&](int i, int j, const Vec3& d, double r2) {
        const double masses = bodies.masses[i].mass * bodies.masses[j].mass;
        const Vec3 pull = gravity.constant * masses / (r2 * std::sqrt(r2)) * d;
        loads[i].force += pull;
        loads[j].force -= pull;
    });
}

double potentialOf(const NBodyGravity& gravity, std::span<const BodyId> on, const Bodies& bodies) {
    double sum = 0.0;
    forEachPair(gravity, on, bodies, [&](int i, int j, const Vec3&, double r2) {
        sum -= gravity.constant * bodies.masses[i].mass * bodies.masses[j].mass / std::sqrt(r2);
    });
    return sum;
}

}  // namespace engine
