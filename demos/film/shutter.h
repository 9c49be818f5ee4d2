/// Motion blur: which moments a frame is the mean of. The shutter closes at the frame's own time,
/// so that bodies end where the numbers and arrows of that time are.
#pragma once
#include <vector>

#include "render/frame.h"

namespace demos {

struct ShutterSettings {
    double open = 0.5;  // of the time between two frames, 0..1; 0: no blur
    int moments = 1;    // pictures averaged into one frame; 1: no blur
};

class Shutter {
public:
    /// `steps`: of the simulation between two frames.
    Shutter(const ShutterSettings& settings, int steps) : settings_(settings), steps_(steps) {}

    /// Whether the frame needs a picture of the state `stepsBefore` steps before its own time.
    bool sees(int stepsBefore) const;

    /// `seen`: one frame per step, the newest last, at least one. Between steps bodies move along
    /// straight lines and turn at a constant rate.
    std::vector<render::Frame> moments(const std::vector<render::Frame>& seen) const;

private:
    double openSteps() const { return settings_.moments > 1 ? settings_.open * steps_ : 0.0; }

    ShutterSettings settings_;
    int steps_;
};

/// Interpolates bodies, bars and camera of one scene; `share` 0: a, 1: b. All else is b's.
render::Frame between(const render::Frame& a, const render::Frame& b, float share);

}  // namespace demos
