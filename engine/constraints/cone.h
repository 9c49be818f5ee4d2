/// Two rows across each other whose impulse is held in a round cone, on accumulated values:
///   |lambda| <= limit
/// It is solved as a 2-vector: the impulse that stops the slip where the cone has room for it, else a
/// step against the slip, cut to the cone. The step is one number times the slip, so that a sliding
/// body is braked straight backwards; cutting the stopping impulse instead, which K has turned, brakes
/// a box 13 % too little and depends on the direction.
#pragma once
#include "engine/constraints/jacobian.h"

namespace engine {

/// Of the two rows, K = J M^-1 J^T; all zero where nothing can be moved.
template <class Real>
struct ConeMass {
    Mat2T<Real> stop = Mat2T<Real>::Zero();  // K^-1
    Real slide = Real(0);                    // 1 / largest eigenvalue of K
};

template <class Real>
ConeMass<Real> coneMass(const Row<Real>& s, const Row<Real>& t) {
    ConeMass<Real> mass;
    const Real ss = s.k, tt = t.k, st = coupling(s, t);
    const Real determinant = ss * tt - st * st;
    if (determinant <= Real(0)) return mass;
    mass.stop << tt / determinant, -st / determinant, -st / determinant, ss / determinant;
    const Real half = Real(0.5) * (ss - tt);
    mass.slide = Real(1) / (Real(0.5) * (ss + tt) + std::sqrt(half * half + st * st));
    return mass;
}

/// Where the accumulated impulse `before` goes, for the slip (m/s or rad/s) that it leaves.
template <class Real>
Vec2T<Real> solveInCone(const ConeMass<Real>& mass, const Vec2T<Real>& before,
                        const Vec2T<Real>& slip, Real limit) {
    Vec2T<Real> wanted = before - mass.stop * slip;
    if (wanted.squaredNorm() <= limit * limit) return wanted;
    wanted = before - mass.slide * slip;
    const Real square = wanted.squaredNorm();
    if (square > limit * limit) wanted *= limit / std::sqrt(square);
    return wanted;
}

}  // namespace engine
