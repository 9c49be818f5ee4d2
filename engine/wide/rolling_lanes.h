/// constraints/rolling.h, eight at a time. The rotation is read from the bodies again after friction, so
/// contacts without rolling resistance, the majority, have no extra cost.
#pragma once
#include "engine/wide/cone_lanes.h"
#include "engine/wide/pair_lanes.h"

namespace engine::ENGINE_LANES {

ENGINE_INLINE bool resistsRolling(const ContactBatch& c) {
    return any(Lanes(0.0f) < Lanes::load(c.rolling));
}

/// A moment about t1 and t2 alone.
ENGINE_INLINE Motion6 onlyMoment(const Lanes2& moment) {
    const Lanes zero(0.0f);
    return {{zero, moment.x, moment.y}, {zero, zero, zero}};
}

ENGINE_INLINE void solveRolling(ContactBatch& c, WideVelocity* v, Corrections& worst) {
    const PairLanes pair(c, v);
    const Lanes3 motion = pair.motion().along;
    Lanes load(0.0f);
    for (const WidePoint& point : c.point)
        load = load + (Lanes::load(point.lambda) + Lanes::load(point.bounce));
    const Lanes2 turn{Lanes::load(c.roll.turn[0]) + motion.y, Lanes::load(c.roll.turn[1]) + motion.z};
    const Lanes2 before{Lanes::load(c.roll.moment[0]), Lanes::load(c.roll.moment[1])};
    const Lanes2 after = solveInCone(c.roll.cone, before, turn, Lanes::load(c.rolling) * load);
    const Lanes2 change{after.x - before.x, after.y - before.y};
    after.x.store(c.roll.moment[0]), after.y.store(c.roll.moment[1]);
    const Lanes most = larger(absolute(change.x), absolute(change.y));
    worst.velocity = larger(worst.velocity, most * Lanes::load(c.roll.cone.k));
    worst.impulse = worst.impulse + (absolute(change.x) + absolute(change.y));
    pair.apply(onlyMoment(change), v);
}

}  // namespace engine::ENGINE_LANES
