/// Effective masses of eight manifolds at their centres, once per step. A unit impulse along e at c changes
/// the spin of a by I_a^-1 (r_a x e) and of b by I_b^-1 (r_b x e); a unit moment about e by I^-1 e:
///   K_ij = (1/m_a + 1/m_b) e_i . e_j + l_ai . I_a^-1 l_aj + l_bi . I_b^-1 l_bj
/// for (N, M_1, M_2), combined by the normal rows (1, y, -x), and for (F_1, F_2, T) of friction.
#pragma once
#include "engine/wide/normal_lanes.h"
#include "engine/wide/pair_lanes.h"
#include "engine/wide/rolling_lanes.h"

namespace engine::ENGINE_LANES {

/// m a, with m stored row by row.
ENGINE_INLINE Lanes3 times(const float (&m)[9][8], const Lanes3& a) {
    const auto row = [&](int i) {
        return Lanes::load(m[i]) * a.x + Lanes::load(m[i + 1]) * a.y + Lanes::load(m[i + 2]) * a.z;
    };
    return {row(0), row(3), row(6)};
}

/// The lever arms l of three unit impulses, and I^-1 l.
struct Levers {
    Lanes3 a[3], b[3], atA[3], atB[3];

    ENGINE_INLINE void finish(const ContactBatch& c) {
        const Symmetric3 turnA = load6(c.turnA), turnB = load6(c.turnB);
        for (int i = 0; i < 3; ++i) atA[i] = turnA * a[i], atB[i] = turnB * b[i];
    }
    /// K without the linear masses.
    static ENGINE_INLINE Lanes k(const Levers& p, int i, const Levers& q, int j) {
        return dot(p.a[i], q.atA[j]) + dot(p.b[i], q.atB[j]);
    }
};

ENGINE_INLINE void storeNormalBlock(ContactBatch& c, const ContactRecord& record,
                                    const Levers& along, const Lanes& mass) {
    Symmetric3 k;
    k.xx = mass + Levers::k(along, 0, along, 0);
    k.xy = Levers::k(along, 0, along, 1), k.xz = Levers::k(along, 0, along, 2);
    k.yy = Levers::k(along, 1, along, 1), k.yz = Levers::k(along, 1, along, 2);
    k.zz = Levers::k(along, 2, along, 2);
    Lanes3 row[4], at[4];
    Mask exists[4], pushes[4], pushed = nowhere();
    for (int i = 0; i < 4; ++i) {
        row[i] = {Lanes(1.0f), Lanes::load(c.point[i].y), -Lanes::load(c.point[i].x)};
        at[i] = k * row[i];
        exists[i] = Lanes::load(record.gapAtStart[i]) < Lanes(kNoPoint);
        pushes[i] = Lanes(0.0f) < Lanes::load(c.point[i].lambda);
        pushed = pushed | pushes[i];
    }
    // With more than one row the diagonal is raised: see normal_block.h.
    const Lanes raise = select(exists[1], Lanes(1.001f), Lanes(1.0f));
    int place = 0;
    for (int i = 0; i < 4; ++i) {
        for (int j = i; j < 4; ++j) {
            const Lanes kij = dot(row[i], at[j]);
            const Lanes here = i == j ? select(exists[i], kij * raise, Lanes(1.0f))
                                      : where(exists[i] & exists[j], kij);
            here.store(c.k[place++]);
        }
        pushes[i] = exists[i] & (pushes[i] | ~pushed);
    }
    storeInverse(Symmetric4{c.k}, pushes, ~nowhere(), c.inverse);
}

/// K^-1 of s_1, s_2, w_n by elimination; only of the first two for a single point.
ENGINE_INLINE void storeTwistMass(ContactBatch& c, const Symmetric3& k, const Mask& twists) {
    const Lanes one(1.0f), zero(0.0f);
    const Mask real = zero < k.xx;
    const Lanes d1 = one / select(real, k.xx, one);
    const Lanes l21 = k.xy * d1, l31 = where(twists, k.xz * d1);
    const Lanes m22 = k.yy - l21 * k.xy, m32 = where(twists, k.yz - l21 * k.xz);
    const Lanes d2 = one / select(real, m22, one), l32 = m32 * d2;
    const Lanes m33 = k.zz - l31 * k.xz - l32 * m32;
    const Mask third = twists & (Lanes(1e-6f) * k.zz < m33);
    const Lanes d3 = where(third, one / select(third, m33, one));
    // L^-1 is 1; -l21 1; u31 -l32 1.
    const Lanes u31 = l21 * l32 - l31;
    const Lanes entries[6] = {d1 + l21 * (l21 * d2) + u31 * (u31 * d3),
                              -(l21 * d2) - u31 * (d3 * l32), u31 * d3,
                              d2 + l32 * (l32 * d3), -(l32 * d3), d3};
    for (int i = 0; i < 6; ++i) where(real, entries[i]).store(c.twistMass[i]);
}

inline void prepare(ContactBatch& c, const ContactRecord& record, ContactSlip& slips) {
    const Lanes3 n = load3(c.n), t1 = load3(c.t1), t2 = load3(c.t2);
    const Lanes3 armA = load3(c.centre), armB = armA + load3(c.offset);
    Levers along, across;
    along.a[0] = cross(armA, n), along.b[0] = cross(armB, n);
    along.a[1] = along.b[1] = t1, along.a[2] = along.b[2] = t2;
    across.a[0] = cross(armA, t1), across.b[0] = cross(armB, t1);
    across.a[1] = cross(armA, t2), across.b[1] = cross(armB, t2);
    across.a[2] = across.b[2] = n;
    along.finish(c), across.finish(c);
    const Lanes mass = Lanes::load(c.massA) + Lanes::load(c.massB);
    storeNormalBlock(c, record, along, mass);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            Levers::k(across, i, along, j).store(c.coupling[3 * i + j]);
    const Symmetric3 k{mass + Levers::k(across, 0, across, 0), Levers::k(across, 0, across, 1),
                       Levers::k(across, 0, across, 2), mass + Levers::k(across, 1, across, 1),
                       Levers::k(across, 1, across, 2), Levers::k(across, 2, across, 2)};
    const Lanes entries[6] = {k.xx, k.xy, k.xz, k.yy, k.yz, k.zz};
    for (int i = 0; i < 6; ++i) entries[i].store(slips.twistK[i]);
    storeTwistMass(c, k, Lanes(0.0f) < Lanes::load(c.reach));
    Lanes(kNotMade).store(slips.slide[0].k);  // most manifolds never slip
    if (resistsRolling(c))
        storeCone(Levers::k(along, 1, along, 1), Levers::k(along, 1, along, 2),
                  Levers::k(along, 2, along, 2), c.roll.cone);
}

}  // namespace engine::ENGINE_LANES
