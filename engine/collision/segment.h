/// Closest points of points and segments. A segment is {centre + t half : -1 <= t <= 1}.
#pragma once
#include "engine/base/math.h"
#include "engine/shape.h"

namespace engine {

struct Segment {
    Vec3 centre, half;
    Vec3 at(double t) const { return centre + t * half; }
};

/// A capsule's core, in world axes.
inline Segment coreOf(const Shape& capsule, const Pose& pose) {
    return {pose.position, pose.rotation * Vec3(0.0, capsule.halfLength, 0.0)};
}

/// t of the point of the segment closest to p.
inline double closestOn(const Segment& s, const Vec3& p) {
    const double square = s.half.squaredNorm();
    return square > 0.0 ? clamped((p - s.centre).dot(s.half) / square, -1.0, 1.0) : 0.0;
}

/// The part of segment a that is alongside b, as parameters on a.
inline bool overlap(const Segment& a, const Segment& b, double& from, double& to) {
    const double square = a.half.squaredNorm();
    const double middle = (b.centre - a.centre).dot(a.half) / square;
    const double reach = std::abs(b.half.dot(a.half)) / square;
    from = larger(middle - reach, -1.0);
    to = smaller(middle + reach, 1.0);
    return to - from > 1e-3;
}

inline bool nearlyParallel(const Vec3& a, const Vec3& b) {
    return a.cross(b).squaredNorm() < 1e-3 * a.squaredNorm() * b.squaredNorm();  // within 1.8 deg
}

}  // namespace engine
