/// Contacts as events: which bodies began or ceased to touch in a step, in the order of pairs. A
/// lasting contact makes no events in between; its impulses are added up. Bodies touch in a step if
/// one of their points overlaps or got an impulse; points ahead of touching do not count.
#pragma once
#include <vector>

#include "engine/collision/broad_phase.h"
#include "engine/step_report.h"
#include "engine/touch_event.h"

namespace engine {

struct WorldState;

/// A touching pair.
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
    std::vector<ContactState> points;  // the same; kept for its memory
};

/// Called after a step, if the log is watched.
void recordTouches(WorldState& s);

}  // namespace engine
