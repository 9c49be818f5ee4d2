/// Eight manifolds in their own frames, once per step: constraints/manifold_frame.h in lanes. In double, because a float
/// has only 1e-7 of an arm: of a body of 10 m, a gap would be known to a micrometre. The arms end where the two bodies
/// will touch, as if b had moved by the gap.
#pragma once
#include "engine/base/double_lanes.h"
#include "engine/wide/contact_batch.h"
#include "engine/wide/contact_inputs.h"

namespace engine::ENGINE_LANES {

/// m a, with m stored column by column.
ENGINE_INLINE Doubles3 turned(const double (&m)[9][8], const double (&a)[3][8], int first) {
    const Doubles3 v = Doubles3::load(a, first);
    const auto row = [&](int i) {
        return Doubles::load(m[i] + first) * v.x +
               (Doubles::load(m[i + 3] + first) * v.y + Doubles::load(m[i + 6] + first) * v.z);
    };
    return {row(0), row(1), row(2)};
}

/// tangents() of base/math.h.
ENGINE_INLINE void tangents(const Doubles3& n, Doubles3& t1, Doubles3& t2) {
    const Doubles x = absolute(n.x), y = absolute(n.y), z = absolute(n.z), one(1.0), zero(0.0);
    const Doubles3 yOrZ = select(y <= z, Doubles3{zero, one, zero}, Doubles3{zero, zero, one});
    const Doubles3 across = cross(n, select((x <= y) & (x <= z), Doubles3{one, zero, zero}, yOrZ));
    t1 = across / squareRoot(dot(across, across));
    t2 = cross(n, t1);
}

/// The points of a manifold, and the plane that touches first.
struct FrameLanes {
    DoubleMask exists[4];
    Doubles3 arm[4];  // of a, m
    Doubles gap[4];   // C, m
    Doubles3 n, t1, t2, centre, offset;

    ENGINE_INLINE FrameLanes(const ContactInputs& from, int first) {
        const Doubles count = Doubles::load(from.count + first), zero(0.0);
        const Doubles3 apart = Doubles3::load(from.apart, first);
        n = Doubles3::load(from.normal, first);
        Doubles3 between[4];
        Doubles open;
        for (int i = 0; i < 4; ++i) {
            exists[i] = Doubles(i) < count;
            arm[i] = turned(from.axesA, from.anchorA[i], first);
            between[i] = turned(from.axesB, from.anchorB[i], first) - arm[i];
            const Doubles here = dot(n, between[i] - apart);
            open = i == 0 ? here : select(exists[i], smaller(open, here), open);
        }
        open = larger(open, zero);
        const Doubles3 slideA = Doubles3::load(from.slideA, first);
        offset = apart + open * n;
        for (int i = 0; i < 4; ++i) {
            const Doubles3 left = between[i] - offset;
            arm[i] = arm[i] + Doubles(0.5) * left + slideA;
            gap[i] = dot(n, left) + open;
        }
        offset = offset + Doubles3::load(from.slideB, first) - slideA;
        findCentre(count);
        tangents(n, t1, t2);
    }

private:
    /// The mean of the points, moved along n to the one that touches first.
    ENGINE_INLINE void findCentre(const Doubles& count) {
        Doubles3 sum{Doubles(0.0), Doubles(0.0), Doubles(0.0)}, deepest = arm[0];
        Doubles least = gap[0];
        for (int i = 0; i < 4; ++i) {
            sum = select(exists[i], sum + arm[i], sum);
            const DoubleMask deeper = exists[i] & (gap[i] < least);
            least = select(deeper, gap[i], least);
            deepest = select(deeper, arm[i], deepest);
        }
        centre = sum / larger(count, Doubles(1.0));
        centre = centre + dot(n, deepest - centre) * n;
    }
};

ENGINE_INLINE void fillPoint(const ContactInputs& from, const FrameLanes& frame, int i, int first, ContactBatch& c,
                             ContactRecord& record, Doubles& reach) {
    const Doubles zero(0.0);
    const DoubleMask several = frame.exists[i] & frame.exists[1];
    const Doubles3 arm = frame.arm[i] - frame.centre, friction = Doubles3::load(from.friction[i], first);
    const Doubles x = select(several, dot(frame.t1, arm), zero), y = select(several, dot(frame.t2, arm), zero);
    reach = larger(reach, larger(absolute(x), absolute(y)));
    WidePoint& point = c.point[i];
    x.store(point.x + first), y.store(point.y + first);
    Doubles::load(from.impulse[i] + first).store(point.lambda + first);
    dot(friction, frame.t1).store(point.friction[0] + first);
    dot(friction, frame.t2).store(point.friction[1] + first);
    const Doubles gap = select(frame.exists[i], frame.gap[i], Doubles(static_cast<double>(kNoPoint)));
    gap.store(record.gapAtStart[i] + first), gap.store(record.separation[i] + first);
}

/// For as many lanes as a register holds.
ENGINE_INLINE void fillSome(const ContactInputs& from, int first, ContactBatch& c, ContactRecord& record) {
    const FrameLanes frame(from, first);
    frame.n.store(c.n, first), frame.t1.store(c.t1, first), frame.t2.store(c.t2, first);
    frame.centre.store(c.centre, first), frame.offset.store(c.offset, first);
    Doubles reach(0.0);
    for (int i = 0; i < ContactBatch::kPoints; ++i) fillPoint(from, frame, i, first, c, record, reach);
    reach.store(c.reach + first);
    const Doubles3 moment = Doubles3::load(from.rollingMoment, first);
    dot(moment, frame.t1).store(c.roll.moment[0] + first), dot(moment, frame.t2).store(c.roll.moment[1] + first);
    const auto narrow = [first](const double (&wide)[8], float (&x)[8]) {
        Doubles::load(wide + first).store(x + first);
    };
    narrow(from.massA, c.massA), narrow(from.massB, c.massB);
    for (int i = 0; i < 6; ++i) narrow(from.turnA[i], c.turnA[i]), narrow(from.turnB[i], c.turnB[i]);
    narrow(from.mu, c.mu), narrow(from.rolling, c.rolling), narrow(from.restitution, record.restitution);
}

inline void fill(const ContactInputs& from, ContactBatch& c, ContactRecord& record) {
    for (int first = 0; first < kLanes; first += kDoubles) fillSome(from, first, c, record);
    const Lanes none(0.0f);
    for (int i = 0; i < ContactBatch::kPoints; ++i) {
        none.store(record.total[i]);
        none.store(record.totalFriction[i][0]), none.store(record.totalFriction[i][1]);
    }
}

}  // namespace engine::ENGINE_LANES
