// The wide contact solver's inner loops: constraints/contact_constraint.h, eight contacts at a time.
// Built once for every instruction set; nothing with external linkage comes from a header here.
#include "engine/wide/contact_kernels.h"

#include "engine/wide/normal_lanes.h"
#include "engine/wide/pair_lanes.h"

namespace engine::ENGINE_LANES {
namespace {

constexpr int kPoints = ContactBatch::kPoints;

/// n . (u + dw x r) of every point, as n . u + r . (n x dw).
ENGINE_INLINE Lanes4 alongNormal(const ContactBatch& c, const PairLanes& pair) {
    const Lanes3 n = load3(c.n);
    const Lanes base = dot(n, pair.base);
    const Lanes3 s = cross(n, pair.turn);
    Lanes4 v;
    for (int i = 0; i < kPoints; ++i) v[i] = base + dot(load3(c.point[i].arm), s);
    return v;
}

/// The impulses `change` along n at the four points, as one.
ENGINE_INLINE void applyNormals(const ContactBatch& c, const Lanes4& change, PairLanes& pair) {
    const Lanes3 n = load3(c.n);
    Lanes3 lever = change[0] * load3(c.point[0].arm);
    for (int i = 1; i < kPoints; ++i) lever = lever + change[i] * load3(c.point[i].arm);
    pair.apply(((change[0] + change[1]) + (change[2] + change[3])) * n, cross(lever, n));
}

// Preparation.

ENGINE_INLINE void storeInverse(ContactBatch& c, const ContactRecord& record) {
    const Symmetric4 k{c.k};
    Mask exists[4];
    for (int i = 0; i < 4; ++i) exists[i] = Lanes::load(record.gapAtStart[i]) < Lanes(kNoPoint);
    int place = 0;
    for (int i = 0; i < 4; ++i) {
        Lanes4 unit;
        for (int j = 0; j < 4; ++j) unit[j] = Lanes(i == j ? -1.0f : 0.0f);
        const Lanes4 column = solveActive(k, unit, exists);
        for (int j = i; j < 4; ++j) where(exists[i], column[j]).store(c.inverse[place++]);
    }
}

ENGINE_INLINE void storeNormalBlock(ContactBatch& c, const ContactRecord& record) {
    const Symmetric3 turnA = load6(c.turnA), turnB = load6(c.turnB);
    const Lanes3 n = load3(c.n), offset = load3(c.offset);
    const Lanes mass = Lanes::load(c.massA) + Lanes::load(c.massB);
    Lanes3 jA[4], jB[4], atA[4], atB[4];
    Mask exists[4];
    for (int i = 0; i < 4; ++i) {
        const Lanes3 arm = load3(c.point[i].arm);
        jA[i] = cross(arm, n), jB[i] = cross(arm + offset, n);
        atA[i] = turnA * jA[i], atB[i] = turnB * jB[i];
        exists[i] = Lanes::load(record.gapAtStart[i]) < Lanes(kNoPoint);
    }
    // Where there is more than one row the diagonal is raised: see normal_block.h.
    const Lanes raise = select(exists[1], Lanes(1.001f), Lanes(1.0f));
    int place = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = i; j < 4; ++j) {
            const Lanes k = mass + dot(jA[i], atA[j]) + dot(jB[i], atB[j]);
            const Lanes here = i == j ? select(exists[i], k * raise, Lanes(1.0f))
                                      : where(exists[i] & exists[j], k);
            here.store(c.k[place++]);
        }
    storeInverse(c, record);
}

ENGINE_INLINE void storeFrictionMass(ContactBatch& c, WidePoint& point) {
    const Symmetric3 turnA = load6(c.turnA), turnB = load6(c.turnB);
    const Lanes3 t1 = load3(c.t1), t2 = load3(c.t2), arm = load3(point.arm);
    const Lanes3 armB = arm + load3(c.offset);
    const Lanes mass = Lanes::load(c.massA) + Lanes::load(c.massB);
    const Lanes3 a1 = cross(arm, t1), a2 = cross(arm, t2), b1 = cross(armB, t1), b2 = cross(armB, t2);
    const Lanes3 turnA1 = turnA * a1, turnB1 = turnB * b1;
    const Lanes k11 = mass + dot(a1, turnA1) + dot(b1, turnB1);
    const Lanes k12 = dot(a2, turnA1) + dot(b2, turnB1);
    const Lanes k22 = mass + dot(a2, turnA * a2) + dot(b2, turnB * b2);
    const Lanes determinant = k11 * k22 - k12 * k12;
    const Mask real = Lanes(0.0f) < determinant;
    const Lanes over = where(real, Lanes(1.0f) / select(real, determinant, Lanes(1.0f)));
    (k22 * over).store(point.frictionMass[0]);
    (-(k12 * over)).store(point.frictionMass[1]);
    (k11 * over).store(point.frictionMass[2]);
    const Lanes half = Lanes(0.5f) * (k11 - k22);
    const Lanes most = Lanes(0.5f) * (k11 + k22) + squareRoot(half * half + k12 * k12);
    where(real, most).store(point.slideK);
    where(real, Lanes(1.0f) / select(real, most, Lanes(1.0f))).store(point.slideMass);
}

void prepare(ContactBatch& c, const ContactRecord& record) {
    storeNormalBlock(c, record);
    for (WidePoint& point : c.point) storeFrictionMass(c, point);
}

// What happens before and after the sweeps.

bool separate(const ContactBatch& c, ContactRecord& record, const WideVelocity* motions,
              const WideStep& step) {
    const PairLanes pair(c, motions);
    Lanes4 separation = alongNormal(c, pair);
    for (int i = 0; i < kPoints; ++i) {
        separation[i] = Lanes::load(record.gapAtStart[i]) + separation[i];
        separation[i].store(record.separation[i]);
    }
    return any(least(separation) < Lanes(-step.slop));
}

void setBiases(ContactBatch& c, ContactRecord& record, const WideVelocity* v,
               const WideStep& step) {
    const PairLanes pair(c, v);
    const Lanes3 t1 = load3(c.t1), t2 = load3(c.t2);
    const Lanes4 approach = alongNormal(c, pair);
    const Lanes zero(0.0f), slop(step.slop), h(step.h);
    const Lanes restitution = Lanes::load(record.restitution);
    for (int i = 0; i < kPoints; ++i) {
        const Lanes separation = Lanes::load(record.separation[i]);
        Lanes bias = where(separation < -slop,
                           (Lanes(step.baumgarte) * (separation + slop)) / h);
        bias = select(zero < separation, separation / h, bias);
        const Mask bounces = (zero < restitution * Lanes(step.bounceByBias)) &
                             (separation + h * approach[i] <= zero) &
                             (approach[i] < Lanes(-step.bounceSpeed));
        bias = select(bounces, restitution * approach[i], bias);
        const Lanes3 between = pair.base + cross(pair.turn, load3(c.point[i].arm));
        dot(t1, between).store(c.point[i].slip[0]);
        dot(t2, between).store(c.point[i].slip[1]);
        approach[i].store(record.approach[i]);
        (bias + approach[i]).store(c.point[i].bias);
        zero.store(c.point[i].bounce);
    }
}

/// All zero where nothing hits, so that the pass ends: solver/impacts.cpp in lanes.
bool bounce(ContactBatch& c, const ContactRecord& record, WideVelocity* v, const WideStep& step) {
    PairLanes pair(c, v);
    Lanes4 approach = alongNormal(c, pair), q;
    const Lanes zero(0.0f), restitution = Lanes::load(record.restitution);
    Mask hitsAnywhere = nowhere();
    for (int i = 0; i < kPoints; ++i) {
        approach[i] = approach[i] + Lanes::load(record.approach[i]);
        const Lanes separation = Lanes::load(record.separation[i]);
        const Mask hits = (approach[i] < Lanes(-step.bounceSpeed)) & (zero < restitution) &
                          (separation + Lanes(step.h) * approach[i] <= zero);
        q[i] = select(hits, (Lanes(1.0f) + restitution) * approach[i], larger(approach[i], zero));
        q[i] = select(Lanes(kNoPoint) <= separation, Lanes(kNoPoint), q[i]);
        hitsAnywhere = hitsAnywhere | hits;
    }
    if (!any(hitsAnywhere)) return false;
    Lanes4 lambda = searchActive(Symmetric4{c.k}, q, -q);
    for (int i = 0; i < kPoints; ++i) {
        lambda[i] = where(hitsAnywhere, lambda[i]);
        (Lanes::load(c.point[i].bounce) + lambda[i]).store(c.point[i].bounce);
    }
    applyNormals(c, lambda, pair);
    pair.store(v);
    return true;
}

void warmStart(ContactBatch& c, WideVelocity* v, const WideStep& step) {
    PairLanes pair(c, v);
    const Lanes keep(step.keep);
    const Lanes3 n = load3(c.n), t1 = load3(c.t1), t2 = load3(c.t2);
    Lanes3 impulse = Lanes(0.0f) * n, moment = impulse;
    for (WidePoint& point : c.point) {
        const Lanes lambda = keep * Lanes::load(point.lambda);
        const Lanes f1 = keep * Lanes::load(point.friction[0]);
        const Lanes f2 = keep * Lanes::load(point.friction[1]);
        lambda.store(point.lambda), f1.store(point.friction[0]), f2.store(point.friction[1]);
        const Lanes3 p = lambda * n + f1 * t1 + f2 * t2;
        impulse = impulse + p;
        moment = moment + cross(load3(point.arm), p);
    }
    pair.apply(impulse, moment);
    pair.store(v);
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

struct Corrections {
    Lanes velocity = Lanes(0.0f), impulse = Lanes(0.0f);
};

ENGINE_INLINE void sweepNormals(ContactBatch& c, PairLanes& pair, Corrections& worst) {
    const Lanes zero(0.0f);
    Lanes4 q = alongNormal(c, pair), before, after, change;
    for (int i = 0; i < kPoints; ++i) {
        q[i] = q[i] + Lanes::load(c.point[i].bias);
        before[i] = Lanes::load(c.point[i].lambda);
    }
    change = Symmetric4{c.inverse} * q;
    for (int i = 0; i < kPoints; ++i) after[i] = before[i] - change[i];
    const Mask letGo = least(after) < zero;
    if (any(letGo)) {
        const Symmetric4 k{c.k};
        const Lanes4 already = k * before;
        Lanes4 alone;
        for (int i = 0; i < kPoints; ++i) alone[i] = q[i] - already[i];
        const Lanes4 found = searchActive(k, alone, before);
        for (int i = 0; i < kPoints; ++i) after[i] = select(letGo, found[i], after[i]);
    }
    for (int i = 0; i < kPoints; ++i) change[i] = after[i] - before[i];
    const Lanes4 dv = Symmetric4{c.k} * change;
    for (int i = 0; i < kPoints; ++i) {
        worst.velocity = larger(worst.velocity, absolute(dv[i]));
        worst.impulse = worst.impulse + absolute(change[i]);
        after[i].store(c.point[i].lambda);
    }
    applyNormals(c, change, pair);
}

/// frictionInCone of eight points: to rest where the cone has room, else a step against the slip.
ENGINE_INLINE void sweepFriction(const ContactBatch& c, WidePoint& point, PairLanes& pair,
                                 Corrections& worst) {
    const Lanes limit = Lanes::load(c.mu) * (Lanes::load(point.lambda) + Lanes::load(point.bounce));
    const Lanes f1 = Lanes::load(point.friction[0]), f2 = Lanes::load(point.friction[1]);
    const Lanes square = limit * limit;
    if (!any((Lanes(0.0f) < square) | (Lanes(0.0f) < f1 * f1 + f2 * f2))) return;
    const Lanes3 arm = load3(point.arm), t1 = load3(c.t1), t2 = load3(c.t2);
    const Lanes3 between = pair.base + cross(pair.turn, arm);
    const Lanes s1 = Lanes::load(point.slip[0]) + dot(t1, between);
    const Lanes s2 = Lanes::load(point.slip[1]) + dot(t2, between);
    const Lanes k12 = Lanes::load(point.frictionMass[1]);
    const Lanes stop1 = f1 - (Lanes::load(point.frictionMass[0]) * s1 + k12 * s2);
    const Lanes stop2 = f2 - (k12 * s1 + Lanes::load(point.frictionMass[2]) * s2);
    const Mask sticks = stop1 * stop1 + stop2 * stop2 <= square;
    Lanes new1 = stop1, new2 = stop2;
    if (any(~sticks)) {  // rare in a heap at rest, and slow: a root and a division
        const Lanes slide = Lanes::load(point.slideMass);
        const Lanes step1 = f1 - slide * s1, step2 = f2 - slide * s2;
        const Lanes length = step1 * step1 + step2 * step2;
        const Mask outside = square < length;
        const Lanes cut = select(
            outside, limit / squareRoot(select(outside, length, Lanes(1.0f))), Lanes(1.0f));
        new1 = select(sticks, stop1, cut * step1);
        new2 = select(sticks, stop2, cut * step2);
    }
    new1.store(point.friction[0]), new2.store(point.friction[1]);
    const Lanes d1 = new1 - f1, d2 = new2 - f2;
    const Lanes most = larger(absolute(d1), absolute(d2));
    worst.velocity = larger(worst.velocity, most * Lanes::load(point.slideK));
    worst.impulse = worst.impulse + (absolute(d1) + absolute(d2));
    const Lanes3 impulse = d1 * t1 + d2 * t2;
    pair.apply(impulse, cross(arm, impulse));
}

WideCorrection sweep(ContactBatch& c, WideVelocity* v) {
    PairLanes pair(c, v);
    Corrections worst;
    sweepNormals(c, pair, worst);
    for (WidePoint& point : c.point) sweepFriction(c, point, pair, worst);
    pair.store(v);
    float velocity[8], impulse[8];
    worst.velocity.store(velocity), worst.impulse.store(impulse);
    WideCorrection sum;
    for (int i = 0; i < 8; ++i) {
        sum.velocity = velocity[i] > sum.velocity ? velocity[i] : sum.velocity;
        sum.impulse += impulse[i];
    }
    return sum;
}

/// Fresh impulses on positions: solver/nudges.cpp in lanes.
bool nudge(const ContactBatch& c, const ContactRecord& record, WideVelocity* ways,
           const WideStep& step) {
    PairLanes pair(c, ways);
    const Lanes zero(0.0f);
    Lanes4 q = alongNormal(c, pair);
    for (int i = 0; i < kPoints; ++i) {
        const Lanes beyond = Lanes::load(record.separation[i]) + q[i] + Lanes(step.slop);
        q[i] = select(beyond < zero, larger(Lanes(step.nudgeFactor) * beyond, Lanes(-step.mostNudge)),
                      beyond);
    }
    if (!any(least(q) < zero)) return false;
    applyNormals(c, searchActive(Symmetric4{c.k}, q, -q), pair);
    pair.store(ways);
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
    prepare, separate, setBiases, bounce, warmStart, sweep, nudge, book};

}  // namespace engine::ENGINE_LANES
