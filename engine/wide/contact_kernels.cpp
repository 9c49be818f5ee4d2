// The wide contact solver's inner loops: constraints/contact_constraint.h, eight contacts at a time.
// Compiled once per instruction set, so no header here may define anything with external linkage.
#include "engine/wide/contact_kernels.h"

#include "engine/wide/fill_lanes.h"
#include "engine/wide/friction_lanes.h"
#include "engine/wide/normal_lanes.h"
#include "engine/wide/pair_lanes.h"
#include "engine/wide/prepare_lanes.h"
#include "engine/wide/rolling_lanes.h"

namespace engine::ENGINE_LANES {
namespace {

constexpr int kPoints = ContactBatch::kPoints;

/// The velocity along n of every point of b relative to that of a.
ENGINE_INLINE Lanes4 alongNormal(const ContactBatch& c, const Lanes3& along) {
    Lanes4 v;
    for (int i = 0; i < kPoints; ++i)
        v[i] = along.x + (Lanes::load(c.point[i].y) * along.y - Lanes::load(c.point[i].x) * along.z);
    return v;
}

/// Combines the impulses along n at the four points to one at c.
ENGINE_INLINE Lanes3 together(const ContactBatch& c, const Lanes4& lambda) {
    Lanes3 all{sum(lambda), Lanes(0.0f), Lanes(0.0f)};
    for (int i = 0; i < kPoints; ++i) {
        all.y = all.y + Lanes::load(c.point[i].y) * lambda[i];
        all.z = all.z - Lanes::load(c.point[i].x) * lambda[i];
    }
    return all;
}

ENGINE_INLINE Motion6 onlyAlong(const Lanes3& along) {
    return {along, {Lanes(0.0f), Lanes(0.0f), Lanes(0.0f)}};
}

// Before and after the sweeps.

bool separate(const ContactBatch& c, ContactRecord& record, const WideVelocity* motions,
              const WideStep& step) {
    Lanes4 separation = alongNormal(c, PairLanes(c, motions).motion().along);
    for (int i = 0; i < kPoints; ++i) {
        separation[i] = Lanes::load(record.gapAtStart[i]) + separation[i];
        separation[i].store(record.separation[i]);
    }
    return any(least(separation) < Lanes(-step.slop));
}

void setBiases(ContactBatch& c, const ContactRecord& record, const WideVelocity* v,
               const WideStep& step) {
    const Motion6 motion = PairLanes(c, v).motion();
    const Lanes4 approach = alongNormal(c, motion.along);
    const Lanes zero(0.0f), slop(step.slop), h(step.h);
    const Lanes restitution = Lanes::load(record.restitution);
    motion.across.x.store(c.slip[0]), motion.across.y.store(c.slip[1]);
    motion.across.z.store(c.slip[2]);
    motion.along.y.store(c.roll.turn[0]), motion.along.z.store(c.roll.turn[1]);
    for (int i = 0; i < kPoints; ++i) {
        const Lanes separation = Lanes::load(record.separation[i]);
        Lanes bias = where(separation < -slop,
                           (Lanes(step.baumgarte) * (separation + slop)) / h);
        bias = select(zero < separation, separation / h, bias);
        const Mask bounces = (zero < restitution * Lanes(step.bounceByBias)) &
                             (separation + h * approach[i] <= zero) &
                             (approach[i] < Lanes(-step.bounceSpeed));
        bias = select(bounces, restitution * approach[i], bias);
        (bias + approach[i]).store(c.point[i].bias);
        zero.store(c.point[i].bounce);
    }
}

void warmStart(ContactBatch& c, WideVelocity* v, const WideStep& step) {
    const PairLanes pair(c, v);
    const Lanes keep(step.keep);
    Lanes4 lambda;
    Lanes3 across{Lanes(0.0f), Lanes(0.0f), Lanes(0.0f)};
    for (int i = 0; i < kPoints; ++i) {
        WidePoint& point = c.point[i];
        lambda[i] = keep * Lanes::load(point.lambda);
        const Lanes f1 = keep * Lanes::load(point.friction[0]);
        const Lanes f2 = keep * Lanes::load(point.friction[1]);
        lambda[i].store(point.lambda), f1.store(point.friction[0]), f2.store(point.friction[1]);
        across = across + Lanes3{f1, f2, Lanes::load(point.x) * f2 - Lanes::load(point.y) * f1};
    }
    Motion6 impulse{together(c, lambda), across};
    if (resistsRolling(c)) {
        const Lanes2 moment{keep * Lanes::load(c.roll.moment[0]), keep * Lanes::load(c.roll.moment[1])};
        moment.x.store(c.roll.moment[0]), moment.y.store(c.roll.moment[1]);
        impulse.along = impulse.along + onlyMoment(moment).along;
    }
    pair.apply(impulse, v);
}

/// lambda . (J v0 + b + J dv / 2)
void measure(const ContactBatch& c, const WideVelocity* changes, float* energy) {
    const Motion6 change = PairLanes(c, changes).motion();
    const Lanes half(0.5f);
    const Lanes3 midway = half * change.along, slip = load3(c.slip) + half * change.across;
    const Lanes4 along = alongNormal(c, midway);
    Lanes sum(0.0f);
    for (int i = 0; i < kPoints; ++i) {
        const WidePoint& p = c.point[i];
        sum = sum + Lanes::load(p.lambda) * (Lanes::load(p.bias) + along[i]);
        sum = sum + Lanes::load(p.friction[0]) * (slip.x - Lanes::load(p.y) * slip.z);
        sum = sum + Lanes::load(p.friction[1]) * (slip.y + Lanes::load(p.x) * slip.z);
    }
    if (resistsRolling(c)) {
        sum = sum + Lanes::load(c.roll.moment[0]) * (Lanes::load(c.roll.turn[0]) + midway.y);
        sum = sum + Lanes::load(c.roll.moment[1]) * (Lanes::load(c.roll.turn[1]) + midway.z);
    }
    sum.store(energy);
}

void book(const ContactBatch& c, ContactRecord& record) {
    for (int i = 0; i < kPoints; ++i) {
        const WidePoint& point = c.point[i];
        (Lanes::load(record.total[i]) + Lanes::load(point.lambda) + Lanes::load(point.bounce))
            .store(record.total[i]);
        for (int t = 0; t < 2; ++t)
            (Lanes::load(record.totalFriction[i][t]) + Lanes::load(point.friction[t]))
                .store(record.totalFriction[i][t]);
    }
}

// The sweep.

/// Active rows that pull, and inactive rows that sink.
ENGINE_INLINE Mask wrongRows(const ContactBatch& c, const Lanes4& before, const Lanes4& after,
                             const Lanes4& left) {
    constexpr int kDiagonal[4] = {0, 4, 7, 9};
    constexpr float kSinking = -1e-6f;  // m/s: rounding
    const Lanes zero(0.0f);
    Mask wrong = nowhere();
    for (int i = 0; i < kPoints; ++i) {
        const Mask pushes = zero < Lanes::load(c.inverse[kDiagonal[i]]);
        const Lanes other = select(left[i] < Lanes(kSinking), Lanes(-1.0f), -before[i]);
        wrong = wrong | (select(pushes, after[i], other) < zero);
    }
    return wrong;
}

/// Returns the change of (N, M_1, M_2). Usually the rows that pushed in the last sweep still do, and one
/// multiplication by the inverse of their block solves them.
ENGINE_INLINE Lanes3 sweepNormals(ContactBatch& c, const Lanes3& along, Corrections& worst) {
    const Symmetric4 k{c.k};
    Lanes4 q = alongNormal(c, along), before, after;
    for (int i = 0; i < kPoints; ++i) {
        q[i] = q[i] + Lanes::load(c.point[i].bias);
        before[i] = Lanes::load(c.point[i].lambda);
    }
    Lanes4 change = -(Symmetric4{c.inverse} * q), dv = k * change;
    Lanes4 left;
    for (int i = 0; i < kPoints; ++i) after[i] = before[i] + change[i], left[i] = q[i] + dv[i];
    const Mask wrong = wrongRows(c, before, after, left);
    if (any(wrong)) {
        Mask active[4];
        const Lanes4 found = searchActive(k, q - k * before, before, active);
        storeInverse(k, active, wrong, c.inverse);
        // The other lanes keep every bit: results must not depend on what shares a batch.
        for (int i = 0; i < kPoints; ++i) {
            after[i] = select(wrong, found[i], after[i]);
            change[i] = select(wrong, found[i] - before[i], change[i]);
        }
        dv = k * change;
    }
    for (int i = 0; i < kPoints; ++i) {
        worst.velocity = larger(worst.velocity, absolute(dv[i]));
        worst.impulse = worst.impulse + absolute(change[i]);
        after[i].store(c.point[i].lambda);
    }
    return together(c, change);
}

ENGINE_INLINE void sweepOne(ContactBatch& c, ContactSlip& slips, WideVelocity* v, Corrections& worst) {
    const PairLanes pair(c, v);
    const Motion6 motion = pair.motion();
    Motion6 impulse = onlyAlong(sweepNormals(c, motion.along, worst));
    if (FrictionLanes::present(c)) {
        const Lanes3 slip = load3(c.slip) + motion.across + times(c.coupling, impulse.along);
        impulse.across = FrictionLanes(c, slips).solve(c.point, slip, worst);
    }
    pair.apply(impulse, v);
    if (resistsRolling(c)) solveRolling(c, v, worst);
}

void sweep(ContactBatch* batches, ContactSlip* slips, int count, WideVelocity* v, WideSums& sums) {
    Corrections worst{Lanes::load(sums.velocity), Lanes::load(sums.impulse)};
    for (int k = 0; k < count; ++k) sweepOne(batches[k], slips[k], v, worst);
    worst.velocity.store(sums.velocity), worst.impulse.store(sums.impulse);
}

/// Impulses on positions: solver/nudges.cpp in lanes.
bool nudge(const ContactBatch& c, const ContactRecord& record, WideVelocity* ways,
           const WideStep& step) {
    const PairLanes pair(c, ways);
    const Lanes zero(0.0f);
    Lanes4 q = alongNormal(c, pair.motion().along);
    for (int i = 0; i < kPoints; ++i) {
        const Lanes beyond = Lanes::load(record.separation[i]) + q[i] + Lanes(step.slop);
        q[i] = select(beyond < zero, larger(Lanes(step.nudgeFactor) * beyond, Lanes(-step.mostNudge)),
                      beyond);
    }
    if (!any(least(q) < zero)) return false;
    Mask active[4];
    pair.apply(onlyAlong(together(c, searchActive(Symmetric4{c.k}, q, -q, active))), ways);
    return true;
}

}  // namespace

extern const ContactKernels kContactKernels;
const ContactKernels kContactKernels{
#if defined(__AVX2__)
    "AVX2",
#else
    "baseline",
#endif
    fill, prepare, separate, setBiases, warmStart, sweep, nudge, book, measure};

}  // namespace engine::ENGINE_LANES
