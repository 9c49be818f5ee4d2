#include "engine/collision/centre_paths.h"

#include <algorithm>

#include "engine/collision/ray_cast.h"
#include "engine/collision/sensors.h"

namespace engine {
namespace {

constexpr double kInFront = 0.05;  // of how far the body reaches: so that no rounding takes it back

void hold(Bodies& bodies, int body, int mesh, std::span<const Pose> before) {
    const Pose& surface = bodies.poses[mesh];
    Vec3& centre = bodies.poses[body].position;
    const Vec3 from = surface.toWorld(before[mesh].toLocal(before[body].position));
    const Shape& shape = bodies.defs[body].shape;
    const auto hit = enterShape(bodies.defs[mesh].shape, surface, from, centre);
    if (hit) centre = from + hit->fraction * (centre - from) + kInFront * reachOf(shape) * hit->normal;
}

}  // namespace

void holdInFront(Bodies& bodies, const ContactFinder& finder, std::span<const Pose> before) {
    for (const PairKey& pair : finder.broadPhase.pairs()) {
        const bool meshA = bodies.defs[pair.a].shape.type == ShapeType::mesh;
        const int mesh = meshA ? pair.a : pair.b, body = meshA ? pair.b : pair.a;
        if (bodies.defs[mesh].shape.type != ShapeType::mesh || !bodies.isAwake(body)) continue;
        // The centre of a ring is not part of it.
        if (bodies.defs[body].shape.type == ShapeType::compound) continue;
        if (std::size_t(larger(pair.a, pair.b)) >= before.size()) continue;
        if (isSensed(bodies, pair) ||
            std::binary_search(finder.jointed.begin(), finder.jointed.end(), pair))
            continue;
        hold(bodies, body, mesh, before);
    }
}

}  // namespace engine
