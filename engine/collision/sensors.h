/// Sensors: bodies that nothing hits and that know whom they overlap. A pair is looked at where it
/// stands at the end of a step; what is past a sensor within one step is not seen.
#pragma once
#include <vector>

#include "engine/collision/broad_phase.h"

namespace engine {

/// A sensor and a body that is in it, or two sensors.
struct Sensed {
    PairKey pair;
    Vec3 position;  // m, in the middle of the points found
    Vec3 normal;    // unit, from a to b
};

/// Whether one of the two is a sensor: they get no contact.
inline bool isSensed(const Bodies& bodies, const PairKey& pair) {
    return bodies.hasSensors && (bodies.defs[pair.a].sensor || bodies.defs[pair.b].sensor);
}

/// All of them, sorted. Who sleeps is looked at as well: a sensor does not forget it.
void findSensed(const Bodies& bodies, const BroadPhase& broadPhase,
                  std::vector<Sensed>& sensed);

}  // namespace engine
