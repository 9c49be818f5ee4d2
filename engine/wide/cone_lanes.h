/// constraints/cone.h, eight at a time.
#pragma once
#include "engine/base/lanes.h"
#include "engine/wide/contact_batch.h"

namespace engine::ENGINE_LANES {

/// Largest |velocity correction| (m/s) and sum of |change of lambda| (N s) so far.
struct Corrections {
    Lanes velocity = Lanes(0.0f), impulse = Lanes(0.0f);
};

/// Along t1 and t2.
struct Lanes2 {
    Lanes x, y;
};

ENGINE_INLINE void storeCone(const Lanes& k11, const Lanes& k12, const Lanes& k22, WideCone& cone) {
    const Lanes determinant = k11 * k22 - k12 * k12;
    const Mask real = Lanes(0.0f) < determinant;
    const Lanes over = where(real, Lanes(1.0f) / select(real, determinant, Lanes(1.0f)));
    (k22 * over).store(cone.stop[0]);
    (-(k12 * over)).store(cone.stop[1]);
    (k11 * over).store(cone.stop[2]);
    const Lanes half = Lanes(0.5f) * (k11 - k22);
    const Lanes most = Lanes(0.5f) * (k11 + k22) + squareRoot(half * half + k12 * k12);
    where(real, most).store(cone.k);
    where(real, Lanes(1.0f) / select(real, most, Lanes(1.0f))).store(cone.mass);
}

ENGINE_INLINE Lanes2 solveInCone(const WideCone& cone, const Lanes2& before, const Lanes2& slip,
                                 const Lanes& limit) {
    const Lanes k12 = Lanes::load(cone.stop[1]), square = limit * limit;
    const Lanes stop1 = before.x - (Lanes::load(cone.stop[0]) * slip.x + k12 * slip.y);
    const Lanes stop2 = before.y - (k12 * slip.x + Lanes::load(cone.stop[2]) * slip.y);
    const Mask stops = stop1 * stop1 + stop2 * stop2 <= square;
    const Lanes mass = Lanes::load(cone.mass);
    const Lanes step1 = before.x - mass * slip.x, step2 = before.y - mass * slip.y;
    const Lanes length = step1 * step1 + step2 * step2;
    const Mask outside = square < length;
    const Lanes cut = select(outside, limit / squareRoot(select(outside, length, Lanes(1.0f))),
                             Lanes(1.0f));
    return {select(stops, stop1, cut * step1), select(stops, stop2, cut * step2)};
}

}  // namespace engine::ENGINE_LANES
