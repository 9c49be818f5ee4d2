/// The normal rows of eight manifolds, each solved together: constraints/normal_block.h in lanes.
///   find lambda >= 0 with w = K lambda + q >= 0 and lambda . w = 0
#pragma once
#include "engine/base/lanes.h"

namespace engine::ENGINE_LANES {

/// Upper triangle of a symmetric 4 x 4 matrix, row after row.
struct Symmetric4 {
    const float (&x)[10][8];
    ENGINE_INLINE Lanes operator()(int i, int j) const {
        constexpr int kPlace[4][4] = {{0, 1, 2, 3}, {1, 4, 5, 6}, {2, 5, 7, 8}, {3, 6, 8, 9}};
        return Lanes::load(x[kPlace[i][j]]);
    }
};

struct Lanes4 {
    Lanes row[4];
    ENGINE_INLINE Lanes& operator[](int i) { return row[i]; }
    ENGINE_INLINE const Lanes& operator[](int i) const { return row[i]; }
};

ENGINE_INLINE Lanes4 operator*(const Symmetric4& m, const Lanes4& a) {
    Lanes4 r;
    for (int i = 0; i < 4; ++i)
        r[i] = m(i, 0) * a[0] + m(i, 1) * a[1] + (m(i, 2) * a[2] + m(i, 3) * a[3]);
    return r;
}
ENGINE_INLINE Lanes4 operator-(const Lanes4& a) { return {{-a[0], -a[1], -a[2], -a[3]}}; }
ENGINE_INLINE Lanes least(const Lanes4& a) {
    return smaller(smaller(a[0], a[1]), smaller(a[2], a[3]));
}

/// x with K x = -q in the active rows and 0 in the others, by elimination.
ENGINE_INLINE Lanes4 solveActive(const Symmetric4& k, const Lanes4& q, const Mask (&active)[4]) {
    Lanes m[4][4], factor;
    Lanes4 x;
    for (int i = 0; i < 4; ++i) {
        for (int j = i + 1; j < 4; ++j) m[i][j] = where(active[i] & active[j], k(i, j));
        m[i][i] = select(active[i], k(i, i), Lanes(1.0f));
        x[i] = where(active[i], -q[i]);
    }
    Lanes inverse[4];
    for (int p = 0; p < 4; ++p) {
        inverse[p] = Lanes(1.0f) / m[p][p];
        for (int i = p + 1; i < 4; ++i) {
            factor = m[p][i] * inverse[p];
            for (int j = i; j < 4; ++j) m[i][j] = m[i][j] - factor * m[p][j];
            x[i] = x[i] - factor * x[p];
        }
    }
    for (int p = 3; p >= 0; --p) {
        for (int j = p + 1; j < 4; ++j) x[p] = x[p] - m[p][j] * x[j];
        x[p] = x[p] * inverse[p];
    }
    return x;
}

/// For the lanes in which not all points push: from a guess (the points with a positive entry: those
/// that pushed before, or that are hit), the worst is let go or taken back until none is wrong. The
/// solution is unique, so the guess is only a matter of time.
inline Lanes4 searchActive(const Symmetric4& k, const Lanes4& q, const Lanes4& guess) {
    constexpr float kSinking = -1e-6f;  // m/s: rounding of K lambda + q
    Mask active[4];
    Lanes4 lambda;
    for (int i = 0; i < 4; ++i) active[i] = Lanes(0.0f) < guess[i], lambda[i] = Lanes(0.0f);
    Mask open = least(q) < Lanes(0.0f);
    for (int change = 0; change < 8 && any(open); ++change) {
        const Lanes4 x = solveActive(k, q, active);
        const Lanes4 w = k * x;
        Lanes4 wrong;  // what has to be mended, the most negative first: pulls before sinking
        const Lanes pull = least(x);
        const Mask pulls = pull < Lanes(0.0f);
        for (int i = 0; i < 4; ++i)
            wrong[i] = select(pulls, x[i], select(active[i], Lanes(0.0f), w[i] + q[i]));
        const Lanes worst = least(wrong);
        const Mask settled = ~pulls & (Lanes(kSinking) <= worst);
        Mask looking = open & ~settled;
        for (int i = 0; i < 4; ++i) {
            lambda[i] = select(open, larger(x[i], Lanes(0.0f)), lambda[i]);
            const Mask flip = looking & (wrong[i] == worst);
            active[i] = active[i] ^ flip;
            looking = looking & ~flip;
        }
        open = open & ~settled;
    }
    return lambda;
}

}  // namespace engine::ENGINE_LANES
