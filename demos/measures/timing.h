/// The cost of a scene: processor time per step, and how it is divided among the loop's phases.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "demos/scene/description.h"
#include "demos/snapshot/player.h"

namespace demos {

/// A timed step is 1/60 s of simulated time, whatever the scene's rate. The last 2 s are timed.
struct Timing {
    std::string scene;
    std::size_t bodies = 0, joints = 0;
    int contacts = 0;        // at the end
    int steps = 0;           // timed ones
    std::vector<double> ms;  // per step
    double points = 0.0;     // contact points, added up over the timed steps
    std::uint64_t hash = 0;
    std::string incident;    // Player::incident; empty: none

    double median() const;  // ms
    double nanosecondsAPoint() const;
};

/// `begin`, if given, may bring the player to a later step. Throws Stop (interrupted; diverged if a
/// step fails) and what `begin` throws.
Timing timeScene(const SceneDescription& scene, const std::function<void(Player&)>& begin = {});

/// The phases of the loop; "prepare" is the time before the first.
constexpr std::array<const char*, 7> kPhaseNames = {"prepare",   "forces", "velocities", "impulses",
                                                    "positions", "nudges", "collisions"};
using PhaseTimes = std::array<double, kPhaseNames.size()>;  // ms per step, mean

/// In a separate run: reading the clock in every phase takes time itself.
PhaseTimes timePhases(const SceneDescription& scene,
                      const std::function<void(Player&)>& begin = {});

}  // namespace demos
