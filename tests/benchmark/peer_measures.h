/// The quality of a scene at one moment, measured from the states of the bodies alone, in the same
/// way for all engines.
#pragma once
#include <cstdint>
#include <span>

#include "tests/benchmark/peer_engine.h"

namespace peers {

using States = std::span<const BodyState>;

/// The errors of all joints at one moment.
struct Separation {
    double worst = 0.0;       // m, between the two anchors
    double meanSquare = 0.0;  // m^2
    double axisAngle = 0.0;   // rad, the worst between the two axes of a hinge
};

/// How far dynamic bodies have moved from their start; the largest of each.
struct Drift {
    double total = 0.0, horizontal = 0.0, vertical = 0.0;  // m
};

Separation separation(const Scene& scene, States states);
Drift drift(const Scene& scene, States states);
double energy(const Scene& scene, States states);         // J, kinetic and potential
Vec3 angularMomentum(const Scene& scene, States states);  // kg m^2/s, of the spins
double fastest(const Scene& scene, States states);        // m/s
int lostBodies(const Scene& scene, States states);
/// m: how far the lowest point of a body is below the ground, for the deepest; 0 without a ground.
double sunk(const Scene& scene, States states);
bool finite(States states);
/// A hash of all poses, bit for bit (FNV-1a).
std::uint64_t hash(States states);

}  // namespace peers
