/// From a stage to a picture's plain values.
#pragma once
#include <vector>

#include "demos/overlays.h"
#include "demos/scene/stage.h"
#include "render/frame.h"

namespace demos {

/// What the overlays need to know of the steps so far, whichever frames were drawn.
struct History {
    double largestImpulse = 0.0;  // N s, of one contact in one step, so far
    double largestNudge = 0.0;    // m, of one body in one step, so far
    std::vector<Vec3> nudges;     // m, by body, of the last step; empty = not watched
};

/// `frameTime`: s, for captions and the camera.
render::Frame snapshot(const Stage& stage, const Overlays& overlays, double frameTime,
                       const History& history = {});

/// The smallest of 1, 2.5, 5, 10, 25 ... that `largest` does not exceed; 1 for 0.
double arrowScale(double largest);

}  // namespace demos
