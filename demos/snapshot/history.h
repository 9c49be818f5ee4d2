/// What pictures need from all steps so far, whichever frames are drawn.
#pragma once
#include <optional>
#include <vector>

#include "demos/look/overlays.h"
#include "demos/play/stage.h"

namespace demos {

struct History {
    // The value of the longest arrow: the largest of one step, halved every half second, so that
    // arrows become visible again after a crash.
    double impulsePeak = 0.0;  // N s, of one contact
    double nudgePeak = 0.0;    // m, of one body

    std::vector<Vec3> nudges;      // m, by body, in the last step; empty = not watched
    double largestValue = 0.0;     // of the colouring, so far
    double lowestPotential = 0.0;  // J, so far, at most 0
    double largestEnergy = 0.0;    // J, so far
    // m: what a camera follows with a lag, now and before the first step
    std::optional<Vec3> followed, followedFirst;
    std::vector<std::vector<engine::Pose>> ghosts;  // by body; the oldest first
};

/// To be called before the first step and after every step; `history.nudges` must be up to date.
void remember(const Stage& stage, const Overlays& overlays, History& history);

}  // namespace demos
