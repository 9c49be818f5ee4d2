/// A smooth curve through points: uniform Catmull-Rom. Between P1 and P2, with their neighbours,
///   p(t) = (2 P1 + (P2 - P0) t + (2 P0 - 5 P1 + 4 P2 - P3) t^2 + (3 P1 - P0 - 3 P2 + P3) t^3) / 2
/// Beyond the end of an open curve, the neighbour is 2 P1 - P2, so it is straight there. The parameter counts
/// points: 2.5 is half way from the third to the fourth. (Catmull and Rom 1974.)
#pragma once
#include <vector>

#include "engine/base/math.h"

namespace engine {

struct CurvePoint {
    Vec3 at, first, second;  // p, dp/dt, d2p/dt2
};

inline int pieces(const std::vector<Vec3>& points, bool closed) {
    return static_cast<int>(points.size()) - (closed ? 0 : 1);
}

/// Point number i, also beyond the ends.
inline Vec3 pointOf(const std::vector<Vec3>& points, bool closed, int i) {
    const int n = static_cast<int>(points.size());
    if (closed) return points[((i % n) + n) % n];
    if (i < 0) return 2.0 * points[0] - points[1];
    if (i >= n) return 2.0 * points[n - 1] - points[n - 2];
    return points[i];
}

/// Brings t into the curve's range: wraps on a closed curve, clamps on an open one.
inline double onCurve(const std::vector<Vec3>& points, bool closed, double t) {
    const double most = pieces(points, closed);
    return closed ? t - most * std::floor(t / most) : clamped(t, 0.0, most);
}

inline CurvePoint curveAt(const std::vector<Vec3>& points, bool closed, double t) {
    const double inside = onCurve(points, closed, t);
    const int i = smaller(static_cast<int>(inside), pieces(points, closed) - 1);
    const Vec3 p0 = pointOf(points, closed, i - 1), p1 = pointOf(points, closed, i);
    const Vec3 p2 = pointOf(points, closed, i + 1), p3 = pointOf(points, closed, i + 2);
    const Vec3 b = p2 - p0, c = 2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3;
    const Vec3 d = 3.0 * p1 - p0 - 3.0 * p2 + p3;
    const double s = inside - i;
    return {0.5 * (2.0 * p1 + s * (b + s * (c + s * d))), 0.5 * (b + s * (2.0 * c + 3.0 * s * d)),
            c + 3.0 * s * d};
}

/// The length of one piece from `from` to `to`, m: Gauss-Legendre with five points.
inline double curveLength(const std::vector<Vec3>& points, bool closed, double from, double to) {
    constexpr double kAt[5] = {-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831,
                               0.9061798459386640};
    constexpr double kWeight[5] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                   0.4786286704993665, 0.2369268850561891};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double sum = 0.0;
    for (int i = 0; i < 5; ++i)
        sum += kWeight[i] * curveAt(points, closed, middle + half * kAt[i]).first.norm();
    return half * sum;
}

/// The parameter whose point is nearest to x, by Newton's method from `t`:  (x - p).p' = 0
inline double nearestOnCurve(const std::vector<Vec3>& points, bool closed, const Vec3& x,
                             double t) {
    for (int i = 0; i < 8; ++i) {
        const CurvePoint p = curveAt(points, closed, t);
        const Vec3 away = x - p.at;
        const double slope = p.first.squaredNorm() - away.dot(p.second);
        const double size = larger(slope, 0.25 * p.first.squaredNorm());  // always a descent direction
        if (size <= 0.0) return t;
        const double step = clamped(away.dot(p.first) / size, -0.25, 0.25);
        t = onCurve(points, closed, t + step);
        if (std::abs(step) < 1e-12) break;
    }
    return t;
}

/// The same without a starting value: samples the whole curve, then uses Newton's method from the best
/// sample.
inline double nearestOnCurve(const std::vector<Vec3>& points, bool closed, const Vec3& x) {
    constexpr int kPerPiece = 16;
    double best = 0.0, least = 1e300;
    for (int i = 0; i <= kPerPiece * pieces(points, closed); ++i) {
        const double t = i / static_cast<double>(kPerPiece);
        const double distance = (curveAt(points, closed, t).at - x).squaredNorm();
        if (distance < least) least = distance, best = t;
    }
    return nearestOnCurve(points, closed, x, best);
}

}  // namespace engine
