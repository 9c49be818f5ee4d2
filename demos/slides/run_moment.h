/// The state of a run at one of its steps, kept while the run continues.
#pragma once
#include <cstdint>
#include <vector>

#include "demos/export/recording.h"
#include "demos/measures/measures.h"
#include "demos/play/stage.h"

namespace demos {

struct RunMoment {
    Measures measures;
    engine::StepReport report;               // of the last step
    std::uint64_t hash = 0;                  // of the state
    double dt = 0.0;                         // s, of a step
    std::vector<BodyMotion> bodies;          // by index in scene.bodies
    std::vector<engine::JointState> joints;  // by index in scene.joints
    std::vector<engine::ContactState> contacts;
};

RunMoment momentOf(const Stage& stage);

}  // namespace demos
