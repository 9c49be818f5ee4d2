/// Eight pairs of bodies while impulses act between them.
///   u  = v_b - v_a + w_b x d      dw = w_b - w_a      the point at r_a moves with u + dw x r_a
///   an impulse P with the moment L about x_a:
///     v_a -= P / m_a, w_a -= I_a^-1 L;   v_b += P / m_b, w_b += I_b^-1 (L + d x P)
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

inline constexpr int kStride = sizeof(WideVelocity) / sizeof(float);

class PairLanes {
public:
    ENGINE_INLINE PairLanes(const ContactBatch& c, const WideVelocity* v)
        : c_(c),
          offset_(load3(c.offset)),
          linearA_(gather(v->linear, kStride, c.a)),
          angularA_(gather(v->angular, kStride, c.a)),
          linearB_(gather(v->linear, kStride, c.b)),
          angularB_(gather(v->angular, kStride, c.b)) {
        base = linearB_ - linearA_ + cross(angularB_, offset_);
        turn = angularB_ - angularA_;
    }

    Lanes3 base, turn;  // u and dw

    ENGINE_INLINE void apply(const Lanes3& impulse, const Lanes3& moment) {
        const Lanes3 atA = load6(c_.turnA) * moment;
        const Lanes3 atB = load6(c_.turnB) * (moment + cross(offset_, impulse));
        const Lanes3 wayA = Lanes::load(c_.massA) * impulse, wayB = Lanes::load(c_.massB) * impulse;
        linearA_ = linearA_ - wayA;
        angularA_ = angularA_ - atA;
        linearB_ = linearB_ + wayB;
        angularB_ = angularB_ + atB;
        base = base + (wayA + wayB) + cross(atB, offset_);
        turn = turn + (atA + atB);
    }

    ENGINE_INLINE void store(WideVelocity* v) const {
        scatter(linearA_, v->linear, kStride, c_.writeA);
        scatter(angularA_, v->angular, kStride, c_.writeA);
        scatter(linearB_, v->linear, kStride, c_.writeB);
        scatter(angularB_, v->angular, kStride, c_.writeB);
    }

private:
    const ContactBatch& c_;
    Lanes3 offset_, linearA_, angularA_, linearB_, angularB_;
};

}  // namespace engine::ENGINE_LANES
