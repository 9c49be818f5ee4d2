/// Joints and springs as bars between bodies, for a page that moves the bodies itself.
#pragma once
#include "demos/export/recording.h"
#include "demos/scene/stage.h"

namespace demos {

/// A place in Recording::bodies; -1 for the body that stands for the world.
int recordedPlace(const Stage& stage, engine::BodyId body);

/// How far a slider has come in all frames so far.
struct SlideRange {
    double low = 0.0, high = 0.0;  // m
};
void widen(const Stage& stage, std::vector<SlideRange>& ranges);

/// What addJoints (snapshot/parts.h) draws of joints that are there and of springs, held by their
/// bodies. `ranges`: by joint.
std::vector<RecordedBar> barsOf(const Stage& stage, const std::vector<SlideRange>& ranges);
std::vector<RecordedJoint> jointsOf(const Stage& stage);

}  // namespace demos
