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

/// Must see every step of a stage.
class ContactLog {
public:
    /// Call after every step.
    void look(const Stage& stage);
    /// Forgets the events, not which pairs touch.
    void clear() { events_.clear(); }
    const std::vector<ContactEvent>& events() const { return events_; }

private:
    using Pair = std::pair<int, int>;
    std::set<Pair> touching_;  // in the last step
    std::vector<ContactEvent> events_;
};

}  // namespace demos
