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
struct ConeMass {
    Mat2 stop = Mat2::Zero();  // K^-1
    double slide = 0.0;        // 1 / largest eigenvalue of K
};

inline ConeMass coneMass(const Row& s, const Row& t) {
    ConeMass mass;
    const double ss = s.k, tt = t.k, st = coupling(s, t);
    const double determinant = ss * tt - st * st;
    if (determinant <= 0.0) return mass;
    mass.stop << tt / determinant, -st / determinant, -st / determinant, ss / determinant;
    const double half = 0.5 * (ss - tt);
    mass.slide = 1.0 / (0.5 * (ss + tt) + std::sqrt(half * half + st * st));
    return mass;
}

/// Where the accumulated impulse `before` goes, for the slip (m/s or rad/s) that it leaves.
inline Vec2 solveInCone(const ConeMass& mass, const Vec2& before, const Vec2& slip, double limit) {
    Vec2 wanted = before - mass.stop * slip;
    if (wanted.squaredNorm() <= limit * limit) return wanted;
    wanted = before - mass.slide * slip;
    const double square = wanted.squaredNorm();
    if (square > limit * limit) wanted *= limit / std::sqrt(square);
    return wanted;
}

}  // namespace engine
