/// Contacts as events: who began to touch in a step, who has parted, in the order of pairs. A
/// contact that lasts makes none in between; its impulses add up. Bodies touch in a step if a point
/// of theirs overlaps or got an impulse: points that the solver looked at ahead of time do not
/// count.
#pragma once
#include <vector>

#include "engine/collision/broad_phase.h"
#include "engine/step_report.h"
#include "engine/touch_event.h"

namespace engine {

struct WorldState;

/// A pair that touches.
struct Touch {
    PairKey pair;
    bool sensor = false;
    Vec3 position = Vec3::Zero(), normal = Vec3::UnitY();
    double speed = 0.0;    // m/s
    double impulse = 0.0;  // N s, in this step
    double total = 0.0;    // N s, since the beginning
};

struct TouchLog {
    bool watched = false;
    std::vector<Touch> before, now;  // sorted by pair
    std::vector<TouchEvent> events;  // of the last step
    std::vector<ContactState> points;  // likewise; kept for its memory
};

/// After a step, if the log is watched.
void recordTouches(WorldState& s);

}  // namespace engine
