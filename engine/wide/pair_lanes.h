/// Eight pairs of bodies in the frames of their contacts, for applying impulses between them. An impulse
/// (F_1, F_2, N) at c with the moment (M_1, M_2, T) about c is, in world axes,
///   P = F_1 t1 + F_2 t2 + N n,   L = M_1 t1 + M_2 t2 + T n + r_a x P
///   v_a -= P / m_a, w_a -= I_a^-1 L;   v_b += P / m_b, w_b += I_b^-1 (L + d x P)
#pragma once
#include "engine/base/gather.h"
#include "engine/wide/contact_batch.h"

namespace engine::ENGINE_LANES {

ENGINE_INLINE Lanes3 load3(const float (&x)[3][8]) {
    return {Lanes::load(x[0]), Lanes::load(x[1]), Lanes::load(x[2])};
}
ENGINE_INLINE Symmetric3 load6(const float (&x)[6][8]) {
    return {Lanes::load(x[0]), Lanes::load(x[1]), Lanes::load(x[2]),
            Lanes::load(x[3]), Lanes::load(x[4]), Lanes::load(x[5])};
}

/// Either the motion (velocity, spin) or the impulse (N s, N m s) of contacts:
///   along   s_n, w_1, w_2   or   N, M_1, M_2: for the normals
///   across  s_1, s_2, w_n   or   F_1, F_2, T: for friction
struct Motion6 {
    Lanes3 along, across;
};

inline constexpr int kStride = sizeof(WideVelocity) / sizeof(float);

class PairLanes {
public:
    ENGINE_INLINE PairLanes(const ContactBatch& c, const WideVelocity* v)
        : c_(c),
          linearA_(gather(v->linear, kStride, c.a)),
          angularA_(gather(v->angular, kStride, c.a)),
          linearB_(gather(v->linear, kStride, c.b)),
          angularB_(gather(v->angular, kStride, c.b)) {}

    /// The motion of b relative to a, at c.
    ENGINE_INLINE Motion6 motion() const {
        const Lanes3 n = load3(c_.n), t1 = load3(c_.t1), t2 = load3(c_.t2);
        const Lanes3 turn = angularB_ - angularA_;
        const Lanes3 at = (linearB_ - linearA_) + cross(angularB_, load3(c_.offset)) +
                          cross(turn, load3(c_.centre));
        return {{dot(n, at), dot(t1, turn), dot(t2, turn)},
                {dot(t1, at), dot(t2, at), dot(n, turn)}};
    }

    ENGINE_INLINE void apply(const Motion6& impulse, WideVelocity* v) const {
        const Lanes3 n = load3(c_.n), t1 = load3(c_.t1), t2 = load3(c_.t2);
        const Lanes3 p = impulse.across.x * t1 + impulse.across.y * t2 + impulse.along.x * n;
        const Lanes3 moment = impulse.along.y * t1 + impulse.along.z * t2 + impulse.across.z * n +
                              cross(load3(c_.centre), p);
        scatter(linearA_ - Lanes::load(c_.massA) * p, v->linear, kStride, c_.writeA);
        scatter(angularA_ - load6(c_.turnA) * moment, v->angular, kStride, c_.writeA);
        const Lanes3 momentB = moment + cross(load3(c_.offset), p);
        scatter(linearB_ + Lanes::load(c_.massB) * p, v->linear, kStride, c_.writeB);
        scatter(angularB_ + load6(c_.turnB) * momentB, v->angular, kStride, c_.writeB);
    }

private:
    const ContactBatch& c_;
    Lanes3 linearA_, angularA_, linearB_, angularB_;
};

}  // namespace engine::ENGINE_LANES
