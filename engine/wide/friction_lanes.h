/// constraints/manifold_friction.h, eight at a time: friction of a manifold as one force and one twist, or,
/// where it slips, point by point.
#pragma once
#include "engine/wide/cone_lanes.h"
#include "engine/wide/pair_lanes.h"

namespace engine::ENGINE_LANES {

/// The cone of one point, with the rows (1, 0, -y) and (0, 1, x).
ENGINE_INLINE void storeSlide(const Symmetric3& k, const WidePoint& point, WideCone& slide) {
    const Lanes x = Lanes::load(point.x), y = Lanes::load(point.y);
    const Lanes zx = k.xz - y * k.zz, zy = k.yz + x * k.zz;  // change of w_n by the rows
    storeCone(k.xx - y * k.xz - y * zx, k.xy - y * k.yz + x * zx, k.yy + x * k.yz + x * zy, slide);
}

/// Of all lanes, when the first one slips after prepare(); the same again for those that have slipped before.
inline void makeSlides(const ContactBatch& c, ContactSlip& slips) {
    const Symmetric3 k = load6(slips.twistK);
    for (int i = 0; i < ContactBatch::kPoints; ++i) storeSlide(k, c.point[i], slips.slide[i]);
}

class FrictionLanes {
public:
    ENGINE_INLINE FrictionLanes(const ContactBatch& c, ContactSlip& slips) : c_(c), slips_(slips) {
        const Lanes mu = Lanes::load(c.mu);
        load_ = total_.x = total_.y = total_.z = Lanes(0.0f);
        for (int i = 0; i < 4; ++i) {
            const WidePoint& point = c.point[i];
            limit_[i] = mu * (Lanes::load(point.lambda) + Lanes::load(point.bounce));
            before1_[i] = Lanes::load(point.friction[0]), before2_[i] = Lanes::load(point.friction[1]);
            x_[i] = Lanes::load(point.x), y_[i] = Lanes::load(point.y);
            load_ = load_ + limit_[i];
            total_.x = total_.x + before1_[i];
            total_.y = total_.y + before2_[i];
            total_.z = total_.z + (x_[i] * before2_[i] - y_[i] * before1_[i]);
        }
    }

    static ENGINE_INLINE bool present(const ContactBatch& c) {
        return any(Lanes(0.0f) < Lanes::load(c.mu));
    }

    /// One sweep against the slip (s_1, s_2, w_n): the change of (F_1, F_2, T).
    ENGINE_INLINE Lanes3 solve(WidePoint (&points)[4], const Lanes3& slip, Corrections& worst) {
        const Lanes3 change = hold(slip, worst);
        Lanes3 sum{where(held_, change.x), where(held_, change.y), where(held_, change.z)};
        const Mask slips = ~held_;
        if (any(slips)) sum = sum + slide(slips, slip, worst);
        for (int i = 0; i < 4; ++i) {
            worst.impulse = worst.impulse + (absolute(after1_[i] - before1_[i]) +
                                             absolute(after2_[i] - before2_[i]));
            after1_[i].store(points[i].friction[0]), after2_[i].store(points[i].friction[1]);
        }
        return sum;
    }

private:
    ENGINE_INLINE Lanes3 hold(const Lanes3& slip, Corrections& worst) {
        const Lanes zero(0.0f), one(1.0f);
        const Mask loaded = zero < load_;  // without load there is no friction
        Lanes3 wanted = total_ - load6(c_.twistMass) * slip;
        wanted = {where(loaded, wanted.x), where(loaded, wanted.y), where(loaded, wanted.z)};
        const Lanes over = one / select(loaded, load_, one);
        Lanes share[4], middle1 = zero, middle2 = zero, spread = zero;
        for (int i = 0; i < 4; ++i) {
            share[i] = limit_[i] * over;
            middle1 = middle1 + share[i] * x_[i];
            middle2 = middle2 + share[i] * y_[i];
        }
        for (int i = 0; i < 4; ++i) {
            const Lanes dx = x_[i] - middle1, dy = y_[i] - middle2;
            spread = spread + share[i] * (dx * dx + dy * dy);
        }
        const Lanes twist = wanted.z - (middle1 * wanted.y - middle2 * wanted.x);
        const Lanes reach = Lanes::load(c_.reach);
        const Mask wide = Lanes(1e-6f) * (reach * reach) < spread;
        const Lanes turned = where(wide, twist / select(wide, spread, one));
        held_ = wide | (twist == zero);
        const Lanes square = load_ * load_;
        for (int i = 0; i < 4; ++i) {
            const Lanes f1 = wanted.x - turned * (y_[i] - middle2);
            const Lanes f2 = wanted.y + turned * (x_[i] - middle1);
            held_ = held_ & ((f1 * f1 + f2 * f2 <= square) | (share[i] == zero));
            after1_[i] = share[i] * f1, after2_[i] = share[i] * f2;
        }
        const Lanes removed = larger(absolute(slip.x), absolute(slip.y)) + reach * absolute(slip.z);
        worst.velocity = larger(worst.velocity, where(held_ & loaded, removed));
        return wanted - total_;
    }

    /// Solves the points of slipping lanes one after the other.
    ENGINE_INLINE Lanes3 slide(const Mask& slips, Lanes3 slip, Corrections& worst) {
        if (any(Lanes::load(slips_.slide[0].k) < Lanes(0.0f))) makeSlides(c_, slips_);
        const Symmetric3 k = load6(slips_.twistK);
        Lanes3 sum = Lanes(0.0f) * slip;
        for (int i = 0; i < 4; ++i) {
            const WideCone& point = slips_.slide[i];
            const Lanes s1 = slip.x - y_[i] * slip.z, s2 = slip.y + x_[i] * slip.z;
            const Lanes &f1 = before1_[i], &f2 = before2_[i];
            const Lanes2 after = solveInCone(point, {f1, f2}, {s1, s2}, limit_[i]);
            after1_[i] = select(slips, after.x, after1_[i]);
            after2_[i] = select(slips, after.y, after2_[i]);
            const Lanes d1 = where(slips, after1_[i] - f1), d2 = where(slips, after2_[i] - f2);
            const Lanes most = larger(absolute(d1), absolute(d2));
            worst.velocity = larger(worst.velocity, most * Lanes::load(point.k));
            const Lanes3 change{d1, d2, x_[i] * d2 - y_[i] * d1};
            sum = sum + change;
            slip = slip + k * change;
        }
        return sum;
    }

    const ContactBatch& c_;
    ContactSlip& slips_;
    Lanes limit_[4], before1_[4], before2_[4], after1_[4], after2_[4], x_[4], y_[4];
    Lanes load_;    // sum of mu lambda, N s
    Lanes3 total_;  // F_1, F_2, T before
    Mask held_;
};

}  // namespace engine::ENGINE_LANES
