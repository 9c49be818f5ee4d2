#include "engine/collision/centre_paths.h"

#include <algorithm>

#include "engine/collision/ray_cast.h"
#include "engine/collision/sensors.h"

namespace engine {
namespace {

constexpr double kInFront = 0.05;  // of the body's reach: more than rounding

/// `centre`: the centre of a convex piece, in the body's axes.
void hold(Bodies& bodies, int body, int mesh, std::span<const Pose> before, const Shape& piece,
          const Vec3& centre) {
    const Pose& surface = bodies.poses[mesh];
    const Vec3 from = surface.toWorld(before[mesh].toLocal(before[body].toWorld(centre)));
    const Vec3 to = bodies.poses[body].toWorld(centre);
    const auto hit = enterShape(bodies.defs[mesh].shape, surface, from, to);
    if (hit)
        bodies.poses[body].position +=
            (1.0 - hit->fraction) * (from - to) + kInFront * reachOf(piece) * hit->normal;
}

void hold(Bodies& bodies, int body, int mesh, std::span<const Pose> before) {
    const Shape& shape = bodies.defs[body].shape;
    if (shape.type != ShapeType::compound)
        return hold(bodies, body, mesh, before, shape, Vec3::Zero());
    for (const ShapePart& part : *shape.parts)
        hold(bodies, body, mesh, before, part.shape, part.pose.position);
}

}  // namespace

void holdInFront(Bodies& bodies, ContactFinder& finder, std::span<const Pose> before) {
    for (const PairKey& pair : finder.broadPhase.awakePairs(bodies)) {
        const bool meshA = bodies.defs[pair.a].shape.type == ShapeType::mesh;
        const int mesh = meshA ? pair.a : pair.b, body = meshA ? pair.b : pair.a;
        if (bodies.defs[mesh].shape.type != ShapeType::mesh || !bodies.isAwake(body)) continue;
        if (bodies.waits(pair.a, pair.b) || isSensed(bodies, pair) || finder.jointed.contains(pair, bodies)) continue;
        hold(bodies, body, mesh, before);
    }
}

}  // namespace engine
