/// What happens in a step besides moving: contacts begin and end, joints break.
#pragma once
#include <string>
#include <vector>

#include "demos/play/stage.h"

namespace demos {

/// A joint carried more than it can bear, and was removed at the end of the step.
struct JointBreak {
    long long step = 0;
    double time = 0.0;             // s, at the end of that step
    int joint = 0;                 // by place in scene.joints
    Vec3 position = Vec3::Zero();  // m, where it held b
    Vec3 force = Vec3::Zero();     // N, on b, mean over the step
    Vec3 torque = Vec3::Zero();    // N m, likewise, about that place
};

/// Each in the order of steps.
struct StageEvents {
    std::vector<engine::TouchEvent> touches;
    std::vector<JointBreak> breaks;

    std::size_t size() const { return touches.size() + breaks.size(); }
};

/// Has to see every step of a stage whose world watches touches.
class EventLog {
public:
    /// Keeps the events of this many steps; 0: of all.
    explicit EventLog(int steps) : steps_(steps) {}
    /// After a step.
    void look(const Stage& stage);
    const StageEvents& events() const { return events_; }

private:
    int steps_;
    long long seen_ = 0;
    StageEvents events_;
};

/// A JSON list, one object an event, in the order of steps; in one step contacts come first.
std::string eventsJson(const StageEvents& events, const Stage& stage);

}  // namespace demos
