/// Which bars and coils a joint or a spring is shown as, in pictures and in exported files alike.
#pragma once
#include <vector>

#include "demos/play/stage.h"

namespace demos {

/// A straight bar or a coil; bodies hold its ends.
struct JointBar {
    int a = -1, b = -1;               // places in scene.bodies; -1: the world
    Vec3 atA{0, 0, 0}, atB{0, 0, 0};  // m, in a's and in b's body axes
    double radius = 0.0;              // m, of a bar
    double rest = -1.0;               // m, length of a coil at rest; negative: a bar
    int joint = 0;  // place in scene.joints; after those, springs by their place in scene.forces
};

/// How far a slider comes: its rail reaches there where no limit ends it.
struct SlideRange {
    double low = 0.0, high = 0.0;  // m
    void widen(double position);
};

/// All that stands at this moment: of joints that are there, then of springs that are forces.
std::vector<JointBar> barsNow(const Stage& stage);
/// The same of a whole run: also of joints that are gone. `slides`: by place in scene.joints.
std::vector<JointBar> barsOfRun(const Stage& stage, const std::vector<SlideRange>& slides);

/// A place in scene.bodies; -1 for the body that stands for the world.
int bodyPlace(const Stage& stage, engine::BodyId body);
/// Where a place is now.
engine::Pose poseAt(const Stage& stage, int place);

}  // namespace demos
