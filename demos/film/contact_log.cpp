#include "demos/film/contact_log.h"

namespace demos {
namespace {

/// Points that are apart and got no impulse were only watched by the solver; they do not count.
bool touches(const engine::ContactState& contact) {
    return contact.penetration >= 0.0 || contact.impulse > 0.0;
}

engine::ContactState parted(int a, int b) {
    const Vec3 none = Vec3::Zero();
    return {{a}, {b}, none, none, 0.0, 0.0, none, 0};
}

}  // namespace

void ContactLog::look(const Stage& stage) {
    const long long step = stage.world.report().step;
    std::set<Pair> now;
    for (const engine::ContactState& contact : stage.world.contacts()) {
        if (!touches(contact)) continue;
        const Pair pair{contact.a.index, contact.b.index};
        now.insert(pair);
        const bool before = touching_.contains(pair);
        events_.push_back(
            {before ? ContactEvent::Kind::persist : ContactEvent::Kind::begin, step, contact});
    }
    for (const Pair& pair : touching_) {
        if (now.contains(pair)) continue;
        events_.push_back({ContactEvent::Kind::end, step, parted(pair.first, pair.second)});
    }
    touching_ = std::move(now);
}

}  // namespace demos
