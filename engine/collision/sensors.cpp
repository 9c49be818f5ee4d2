#include "engine/collision/sensors.h"

#include "engine/collision/collide.h"

namespace engine {

void findSensed(const Bodies& bodies, const BroadPhase& broadPhase,
                  std::vector<Sensed>& sensed) {
    sensed.clear();
    for (const PairKey& pair : broadPhase.pairs()) {
        if (!isSensed(bodies, pair) || !broadPhase.boundsMeet(pair)) continue;
        const Manifold m = collide(bodies.defs[pair.a].shape, bodies.poses[pair.a],
                                   bodies.defs[pair.b].shape, bodies.poses[pair.b], 0.0);
        Vec3 sum = Vec3::Zero();
        int count = 0;
        for (int i = 0; i < m.count; ++i) {
            if (m.separation(i) > 0.0) continue;
            sum += 0.5 * (m.points[i].onA + m.points[i].onB);
            ++count;
        }
        if (count > 0) sensed.push_back({pair, sum / count, m.normal});
    }
}

}  // namespace engine
