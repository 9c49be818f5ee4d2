/// Contacts as events: which pairs of bodies began to touch, touch still, or have parted.
#pragma once
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "demos/play/stage.h"

namespace demos {

struct ContactEvent {
    enum class Kind { begin, persist, end };
    Kind kind = Kind::begin;
    long long step = 0;
    engine::ContactState contact;  // end: only a and b
};

/// Has to see every step of a stage; keeps the events of the last frame's.
class ContactLog {
public:
    explicit ContactLog(int stepsPerFrame) : stepsPerFrame_(stepsPerFrame) {}
    /// After a step.
    void look(const Stage& stage);
    const std::vector<ContactEvent>& events() const { return events_; }

private:
    using Pair = std::pair<int, int>;
    int stepsPerFrame_;
    std::set<Pair> touching_;  // in the last step
    std::vector<ContactEvent> events_;
};

}  // namespace demos
