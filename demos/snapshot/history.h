/// What pictures need to know of the steps so far, whichever frames are drawn.
#pragma once
#include <optional>
#include <vector>

#include "demos/look/overlays.h"
#include "demos/play/stage.h"

namespace demos {

struct History {
    // What the longest arrow stands for: the largest of one step, halved every half second, so that
    // what a crash leaves behind is seen again.
    double impulsePeak = 0.0;  // N s, of one contact
    double nudgePeak = 0.0;    // m, of one body

    std::vector<Vec3> nudges;      // m, by body, of the last step; empty = not watched
    double largestValue = 0.0;     // of what the bodies are coloured by, so far
    double lowestPotential = 0.0;  // J, so far, and 0 at most
    double largestEnergy = 0.0;    // J, so far
    std::optional<Vec3> followed;  // m: where the camera that follows with a lag believes its body
    std::vector<std::vector<engine::Pose>> ghosts;  // by body; the oldest first
};

/// After every step, and before the first. `history.nudges` is up to date already.
void remember(const Stage& stage, const Overlays& overlays, History& history);

}  // namespace demos
