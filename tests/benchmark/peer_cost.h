/// The cost of a step. Only time is measured here; watch() (peer_quality.h) measures quality in
/// a separate run.
#pragma once
#include "tests/benchmark/peer_engine.h"

namespace peers {

/// Medians over the steps of the first and of the last two simulated seconds.
struct Cost {
    double first = 0.0, last = 0.0;          // s of processor time per step, all threads together
    double wallFirst = 0.0, wallLast = 0.0;  // s on the clock per step
    double points = 0.0;                     // contact points after the last step
    int steps = 0;

    double perPoint() const { return points > 0.0 ? last / points : 0.0; }  // s; 0: no contacts
};

/// Runs the scene once; ends early after `budget` seconds on the clock.
Cost measureCost(const Scene& scene, Engine& engine, double budget);

/// The median of each number, and the most steps.
Cost median(const std::vector<Cost>& runs);

}  // namespace peers
