/// Which moments a frame's light comes from: motion blur. The shutter closes at the frame's own
/// time, so that bodies end up where the numbers and arrows of that time say they are.
#pragma once
#include <vector>

#include "render/frame.h"

namespace demos {

struct ShutterSettings {
    double open = 0.5;  // of the time between two frames, 0..1; 0: bodies stand still in a frame
    int moments = 1;    // pictures a frame is the mean of; 1: no blur
};

class Shutter {
public:
    /// `steps`: of the simulation, between two frames.
    Shutter(const ShutterSettings& settings, int steps) : settings_(settings), steps_(steps) {}

    /// Whether the frame needs a picture of the state so many steps before its own time.
    bool sees(int stepsBefore) const;

    /// `seen`: a frame a step, the newest last, at least that one. Between steps bodies move along
    /// straight lines and turn evenly.
    std::vector<render::Frame> moments(const std::vector<render::Frame>& seen) const;

private:
    double openSteps() const { return settings_.moments > 1 ? settings_.open * steps_ : 0.0; }

    ShutterSettings settings_;
    int steps_;
};

/// Bodies, bars and camera between two frames of the same scene; 0: a, 1: b. All else is b's.
render::Frame between(const render::Frame& a, const render::Frame& b, float share);

}  // namespace demos
