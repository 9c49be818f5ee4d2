/// What a scene costs: processor time per step, and how it parts into the phases of the loop.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "demos/scene/description.h"

namespace demos {

/// Of a step that is timed: 1/60 s of simulated time, whatever the scene's own. The last 2 s count.
struct Timing {
    std::string scene;
    std::size_t bodies = 0, joints = 0;
    int contacts = 0;        // at the end
    int steps = 0;           // that were timed
    std::vector<double> ms;  // a step
    double points = 0.0;     // contact points, added up over the timed steps
    std::uint64_t hash = 0;

    double median() const;  // ms
    double nanosecondsAPoint() const;
};

/// Throws Stop (diverged, interrupted).
Timing timeScene(const SceneDescription& scene);

/// The loop's phases, and what comes before the first.
constexpr std::array<const char*, 7> kPhaseNames = {"prepare",   "forces", "velocities", "impulses",
                                                    "positions", "nudges", "collisions"};
using PhaseTimes = std::array<double, kPhaseNames.size()>;  // ms a step, mean

/// In a run of its own: looking at the clock in every phase costs time itself.
PhaseTimes timePhases(const SceneDescription& scene);

}  // namespace demos
