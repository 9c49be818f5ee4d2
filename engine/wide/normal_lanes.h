/// The normal rows of eight manifolds, each solved together: constraints/normal_block.h in lanes.
///   find lambda >= 0 with w = K lambda + q >= 0 and lambda . w = 0
#pragma once
#include "engine/base/lanes.h"

namespace engine::ENGINE_LANES {

/// Upper triangle of a symmetric 4 x 4 matrix, row by row.
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
ENGINE_INLINE Lanes4 operator-(const Lanes4& a, const Lanes4& b) {
    return {{a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]}};
}
ENGINE_INLINE Lanes4 operator-(const Lanes4& a) { return {{-a[0], -a[1], -a[2], -a[3]}}; }
ENGINE_INLINE Lanes least(const Lanes4& a) {
    return smaller(smaller(a[0], a[1]), smaller(a[2], a[3]));
}
ENGINE_INLINE Lanes sum(const Lanes4& a) { return (a[0] + a[1]) + (a[2] + a[3]); }

/// K = L D L^T of the active rows; the others are treated as rows of the unit matrix.
class ActiveRows {
public:
    ENGINE_INLINE ActiveRows(const Symmetric4& k, const Mask (&active)[4]) {
        for (int i = 0; i < 4; ++i) {
            active_[i] = active[i];
            for (int j = i + 1; j < 4; ++j) m_[i][j] = where(active[i] & active[j], k(i, j));
            m_[i][i] = select(active[i], k(i, i), Lanes(1.0f));
        }
        for (int p = 0; p < 4; ++p) {
            over_[p] = Lanes(1.0f) / m_[p][p];
            for (int i = p + 1; i < 4; ++i) {
                const Lanes factor = m_[p][i] * over_[p];
                for (int j = i; j < 4; ++j) m_[i][j] = m_[i][j] - factor * m_[p][j];
            }
        }
    }

    /// Returns x with K x = b in the active rows and 0 in the others.
    ENGINE_INLINE Lanes4 solve(const Lanes4& b) const {
        Lanes4 x;
        for (int i = 0; i < 4; ++i) x[i] = where(active_[i], b[i]);
        for (int p = 0; p < 4; ++p)
            for (int i = p + 1; i < 4; ++i) x[i] = x[i] - (m_[p][i] * over_[p]) * x[p];
        for (int p = 3; p >= 0; --p) {
            for (int j = p + 1; j < 4; ++j) x[p] = x[p] - m_[p][j] * x[j];
            x[p] = x[p] * over_[p];
        }
        return x;
    }

private:
    Mask active_[4];
    Lanes m_[4][4], over_[4];
};

/// Writes the inverse of the active rows into the lanes of `wanted`.
inline void storeInverse(const Symmetric4& k, const Mask (&active)[4], const Mask& wanted,
                         float (&inverse)[10][8]) {
    const ActiveRows rows(k, active);
    int place = 0;
    for (int i = 0; i < 4; ++i) {
        Lanes4 unit;
        for (int j = 0; j < 4; ++j) unit[j] = Lanes(i == j ? 1.0f : 0.0f);
        const Lanes4 column = rows.solve(unit);
        for (int j = i; j < 4; ++j, ++place) {
            const Lanes entry = where(active[i] & active[j], column[j]);
            select(wanted, entry, Lanes::load(inverse[place])).store(inverse[place]);
        }
    }
}

/// For lanes whose set of pushing points has changed. Starting from a guess (the points with a positive
/// entry: those that pushed before, or that are hit), the worst point is removed or added until none is
/// wrong. The solution is unique, so the guess affects only the time. `active`: the points that push.
inline Lanes4 searchActive(const Symmetric4& k, const Lanes4& q, const Lanes4& guess,
                           Mask (&active)[4]) {
    constexpr float kSinking = -1e-6f;  // m/s: rounding of K lambda + q
    Lanes4 lambda;
    for (int i = 0; i < 4; ++i) active[i] = Lanes(0.0f) < guess[i], lambda[i] = Lanes(0.0f);
    Mask open = least(q) < Lanes(0.0f);
    for (int i = 0; i < 4; ++i) active[i] = active[i] & open;
    for (int change = 0; change < 8 && any(open); ++change) {
        const Lanes4 x = ActiveRows(k, active).solve(-q);
        const Lanes4 w = k * x;
        Lanes4 wrong;  // violations, the most negative first: pulling before sinking
        const Mask pulls = least(x) < Lanes(0.0f);
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
