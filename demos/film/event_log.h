/// Begin and end of contacts, as the engine tells them step by step (engine::TouchEvent).
#pragma once
#include <string>
#include <vector>

#include "demos/scene/stage.h"

namespace demos {

/// Has to see every step of a stage whose world watches touches.
class EventLog {
public:
    /// Keeps the events of this many steps; 0: of all.
    explicit EventLog(int steps) : steps_(steps) {}
    /// After a step.
    void look(const Stage& stage);
    const std::vector<engine::TouchEvent>& events() const { return events_; }

private:
    int steps_;
    long long seen_ = 0;
    std::vector<engine::TouchEvent> events_;
};

/// A JSON list, one object an event.
std::string eventsJson(const std::vector<engine::TouchEvent>& events, const Stage& stage);

}  // namespace demos
