/// The events of steps: contacts that begin and end, joints that break.
#pragma once
#include <string>
#include <vector>

#include "demos/play/stage.h"

namespace demos {

/// A joint exceeded its limits and was removed at the end of the step.
struct JointBreak {
    long long step = 0;
    double time = 0.0;             // s, at the end of that step
    int joint = 0;                 // index in scene.joints
    Vec3 position = Vec3::Zero();  // m, its anchor on b
    Vec3 force = Vec3::Zero();     // N, on b, mean over the step
    Vec3 torque = Vec3::Zero();    // N m, likewise, about that anchor
};

/// Each in the order of steps.
struct StageEvents {
    std::vector<engine::TouchEvent> touches;
    std::vector<JointBreak> breaks;

    std::size_t size() const { return touches.size() + breaks.size(); }
};

/// Must see every step of a stage whose world watches touches.
class EventLog {
public:
    /// Call after every step.
    void look(const Stage& stage);
    /// Forgets the events.
    void clear() { events_ = {}; }
    const StageEvents& events() const { return events_; }

private:
    StageEvents events_;
};

/// A JSON list, one object per event, in the order of steps; within a step contacts come first.
std::string eventsJson(const StageEvents& events, const Stage& stage);

}  // namespace demos
