/// Sensors: bodies that collide with nothing and record what they overlap. A pair is tested at its
/// poses at the end of a step; a body that passes a sensor within one step is missed.
#pragma once
#include <vector>

#include "engine/collision/broad_phase.h"

namespace engine {

/// A sensor and a body that is in it, or two sensors.
struct Sensed {
    PairKey pair;
    Vec3 position;  // m, mean of the points found
    Vec3 normal;    // unit, from a to b
};

/// Whether one of the two is a sensor; such pairs get no contact.
inline bool isSensed(const Bodies& bodies, const PairKey& pair) {
    return bodies.hasSensors && (bodies.defs[pair.a].sensor || bodies.defs[pair.b].sensor);
}

/// Finds all overlaps, sorted. Sleeping bodies are included, so a sensor does not lose them.
/// False if they have too many pieces (kMostPiecePairs).
[[nodiscard]] bool findSensed(const Bodies& bodies, const BroadPhase& broadPhase, std::vector<Sensed>& sensed);

}  // namespace engine
