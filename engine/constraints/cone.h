/// Two perpendicular rows whose accumulated impulse is limited to a round cone:
///   |lambda| <= limit
/// It is solved as a 2-vector: the impulse that stops the slip if it is inside the cone, else a step against
/// the slip, clamped to the cone. The step is a scalar times the slip, so a sliding body is braked exactly
/// against its motion. Clamping the stopping impulse instead, whose direction K has changed, brakes a box 13
/// % too little and depends on the direction.
#pragma once
#include "engine/constraints/jacobian.h"

namespace engine {

/// For K = J M^-1 J^T of the two rows; all zero if neither body can move.
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

/// The new accumulated impulse, from the one `before` and the slip (m/s or rad/s) it leaves.
inline Vec2 solveInCone(const ConeMass& mass, const Vec2& before, const Vec2& slip, double limit) {
    Vec2 wanted = before - mass.stop * slip;
    if (wanted.squaredNorm() <= limit * limit) return wanted;
    wanted = before - mass.slide * slip;
    const double square = wanted.squaredNorm();
    if (square > limit * limit) wanted *= limit / std::sqrt(square);
    return wanted;
}

}  // namespace engine
