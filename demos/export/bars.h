/// Joints as drawn: bars that keep their numbers from frame to frame.
#pragma once
#include <string>
#include <vector>

#include "demos/export/recording.h"

namespace demos {

/// One bar through all frames: a cylinder along its own y.
struct BarMotion {
    std::string name;                 // its joint's name and a number
    std::vector<engine::Pose> poses;  // m, of its middle; the last one while it is gone
    std::vector<render::Vec3> sizes;  // m: radius, half length, radius; zero while it is gone
};

/// In the order of joints, then of springs that are forces; a coil is one bar, as thick as its wire.
std::vector<BarMotion> barsOf(const Recording& recording);

}  // namespace demos
