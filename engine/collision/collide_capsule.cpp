/// Capsule against capsule: two thick segments; one point or, if they are parallel, two.
#include "engine/collision/collide.h"
#include "engine/collision/segment.h"

namespace engine {
namespace {

void addBalls(Manifold& m, const Vec3& p, double rp, const Vec3& q, double rq, double margin,
              int feature) {
    const double separation = m.normal.dot(q - p) - rp - rq;
    if (separation <= margin) {
        const Vec3 onA = p + rp * m.normal;
        m.add(onA, onA + separation * m.normal, feature);
    }
}

/// Closest parameters of two segments (Ericson, Real-Time Collision Detection, 5.1.9).
void closestParameters(const Segment& a, const Segment& b, double& s, double& t) {
    const Vec3 r = b.centre - a.centre;
    const double aa = a.half.squaredNorm(), bb = b.half.squaredNorm(), ab = a.half.dot(b.half);
    const double determinant = aa * bb - ab * ab;
    s = determinant > 1e-12 * aa * bb
            ? clamped((r.dot(a.half) * bb - r.dot(b.half) * ab) / determinant, -1.0, 1.0)
            : 0.0;
    t = closestOn(b, a.at(s));
    s = closestOn(a, b.at(t));
}

}  // namespace

Manifold collideCapsuleCapsule(const Shape& a, const Pose& poseA, const Shape& b,
                               const Pose& poseB, double margin) {
    const Segment coreA = coreOf(a, poseA), coreB = coreOf(b, poseB);
    double s = 0.0, t = 0.0;
    closestParameters(coreA, coreB, s, t);
    const Vec3 between = coreB.at(t) - coreA.at(s);
    const double distance = between.norm();
    Manifold m;
    if (distance - a.radius - b.radius > margin) return m;
    if (distance > 0.0)
        m.normal = between / distance;
    else  // cores cross: separate them along their common normal
        m.normal = coreA.half.cross(coreB.half).squaredNorm() > 0.0
                       ? Vec3(coreA.half.cross(coreB.half).normalized())
                       : Vec3(Vec3::UnitY());
    double from = 0.0, to = 0.0;
    const bool along = coreA.half.squaredNorm() > 0.0 && coreB.half.squaredNorm() > 0.0 &&
                       nearlyParallel(coreA.half, coreB.half) && overlap(coreA, coreB, from, to);
    if (!along) {
        addBalls(m, coreA.at(s), a.radius, coreB.at(t), b.radius, margin, 0);
        return m;
    }
    for (const int end : {0, 1}) {
        const Vec3 p = coreA.at(end == 0 ? from : to);
        addBalls(m, p, a.radius, coreB.at(closestOn(coreB, p)), b.radius, margin, 1 + end);
    }
    return m;
}

}  // namespace engine
