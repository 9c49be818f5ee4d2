/// The bars and coils that show joints and springs, both in pictures and in exported files.
#pragma once
#include <vector>

#include "demos/play/stage.h"

namespace demos {

/// A straight bar or a coil whose ends are fixed to bodies.
struct JointBar {
    int a = -1, b = -1;               // indices in scene.bodies; -1: the world
    Vec3 atA{0, 0, 0}, atB{0, 0, 0};  // m, in the body axes of a and b
    double radius = 0.0;              // m, of a bar
    double rest = -1.0;               // m, length of a coil at rest; negative: a bar
    int joint = 0;  // index in scene.joints; springs come after, by their index in scene.forces
};

/// The range of a slider's positions: its rail covers it if there is no limit.
struct SlideRange {
    double low = 0.0, high = 0.0;  // m
    void widen(double position);
};

/// All bars at this moment: those of joints that exist, then those of spring forces.
std::vector<JointBar> barsNow(const Stage& stage);
/// The same for a whole run: also of removed joints. `slides`: by index in scene.joints.
std::vector<JointBar> barsOfRun(const Stage& stage, const std::vector<SlideRange>& slides);

/// The index in scene.bodies; -1 for the body that represents the world.
int bodyPlace(const Stage& stage, engine::BodyId body);
/// The current pose for such an index.
engine::Pose poseAt(const Stage& stage, int place);

}  // namespace demos
