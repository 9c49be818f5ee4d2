/// How well an engine did in a scene, from the first step to the last.
#pragma once
#include <string>

#include "tests/benchmark/peer_measures.h"
#include "tests/benchmark/peer_penetration.h"

namespace peers {

/// Measures of one moment, and of the run until then.
struct Quality {
    int steps = 0;             // steps that were done
    double fallTime = -1.0;    // s; -1: it did not fall
    double gaveUpTime = -1.0;  // s; -1: every step went well and left finite states
    Drift drift;               // at the end
    double fastest = 0.0;      // m/s, at the end
    int lost = 0;              // bodies, at the end
    double sunk = 0.0;         // m, into the ground, at the end
    std::uint64_t hash = 0;    // at the end

    Penetration penetration;        // at the end
    double worstPenetration = 0.0;  // m
    Separation separation;          // at the end
    double worstSeparation = 0.0;   // m
    double rmsSeparation = 0.0;     // m, over all joints and steps
    double worstAxisAngle = 0.0;    // rad

    double energyLow = 0.0;      // change of energy over the scene's scale: the lowest,
    double energyHigh = 0.0;     // the highest
    double energyEnd = 0.0;      // and the last
    double momentumError = 0.0;  // | |L| / |L0| - 1 |, the worst
    double momentumAngle = 0.0;  // rad between L and L0, the worst

    int points = 0;  // contact points as the engine counts them, at the end
    int mostPoints = 0;
};

/// Runs the scene once and watches every step; ends early after `budget` seconds on the clock.
Quality watch(const Scene& scene, Engine& engine, double budget);

/// The measures that matter in this scene, in a few words.
std::string verdict(const Scene& scene, const Quality& quality);

}  // namespace peers
