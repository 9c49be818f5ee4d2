/// Contacts as events: which pairs of bodies began to touch, still touch or have separated.
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

/// Must see every step of a stage. Keeps the events of the latest frame's steps.
class ContactLog {
public:
    explicit ContactLog(int stepsPerFrame) : stepsPerFrame_(stepsPerFrame) {}
    /// Call after every step.
    void look(const Stage& stage);
    const std::vector<ContactEvent>& events() const { return events_; }

private:
    using Pair = std::pair<int, int>;
    int stepsPerFrame_;
    std::set<Pair> touching_;  // in the last step
    std::vector<ContactEvent> events_;
};

}  // namespace demos
