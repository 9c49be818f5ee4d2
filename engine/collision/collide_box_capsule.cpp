/// Box against capsule, in the box's axes. Core outside: the closest point gives the normal; where
/// that is (nearly) the normal of a face, the core clipped to the face gives two points. Core
/// inside: the axis of least penetration among the face normals and the cross products of the box
/// edges with the core.
#include "engine/collision/collide.h"
#include "engine/collision/segment.h"

namespace engine {
namespace {

Vec3 closestInBox(const Vec3& p, const Vec3& half) { return p.cwiseMax(-half).cwiseMin(half); }

/// t of the point of the segment closest to the box. The squared distance is convex in t, and its
/// slope is piecewise linear, with kinks where the segment passes a face's plane: the kinks are
/// searched for the interval in which the slope changes sign, and it is solved there.
double closestToBox(const Segment& s, const Vec3& half) {
    const auto slope = [&](double t) {
        const Vec3 p = s.at(t);
        return (p - closestInBox(p, half)).dot(s.half);
    };
    double low = -1.0, high = 1.0;
    if (slope(low) >= 0.0) return low;
    if (slope(high) <= 0.0) return high;
    for (int i = 0; i < 3; ++i)
        for (const double side : {-1.0, 1.0}) {
            if (s.half[i] == 0.0) continue;
            const double kink = (side * half[i] - s.centre[i]) / s.half[i];
            if (kink <= low || kink >= high) continue;
            if (slope(kink) > 0.0)
                high = kink;
            else
                low = kink;
        }
    const double below = slope(low), above = slope(high);  // below <= 0 < above
    return low - below * (high - low) / (above - below);
}

struct Axis {
    double separation = -1e300;
    Vec3 normal = Vec3::Zero();  // from the box to the core
    bool face = false;
};

/// The axis of least penetration of the core (without its radius) and the box.
Axis leastPenetration(const Segment& s, const Vec3& half) {
    Axis best;
    const auto consider = [&](const Vec3& n, bool face) {
        const Vec3 out = n.dot(s.centre) < 0.0 ? Vec3(-n) : n;
        const double separation =
            out.dot(s.centre) - std::abs(out.dot(s.half)) - out.cwiseAbs().dot(half);
        // An edge must be clearly better than a face, which gives two points.
        if (separation > best.separation + (face ? 0.0 : 2e-3)) best = {separation, out, face};
    };
    for (int i = 0; i < 3; ++i) consider(Vec3::Unit(i), true);
    for (int i = 0; i < 3; ++i) {
        const Vec3 n = Vec3(Vec3::Unit(i)).cross(s.half);
        if (n.squaredNorm() > 1e-6 * s.half.squaredNorm()) consider(n.normalized(), false);
    }
    return best;
}

/// The part of the core above the face `axis`, as parameters; false when there is none.
bool clipToFace(const Segment& s, const Vec3& half, int axis, double& from, double& to) {
    from = -1.0, to = 1.0;
    for (int i = 0; i < 3; ++i) {
        if (i == axis) continue;
        if (s.half[i] == 0.0) {
            if (std::abs(s.centre[i]) > half[i]) return false;
            continue;
        }
        const double a = (-half[i] - s.centre[i]) / s.half[i];
        const double b = (half[i] - s.centre[i]) / s.half[i];
        from = larger(from, smaller(a, b));
        to = smaller(to, larger(a, b));
    }
    return to - from > 1e-6;
}

/// Two points along the face, in the box's axes. False: no part of the core is above it.
bool alongFace(const Segment& s, const Vec3& half, double radius, double margin, int axis,
               double side, Manifold& m) {
    double from = 0.0, to = 0.0;
    if (!clipToFace(s, half, axis, from, to)) return false;
    m.normal = side * Vec3::Unit(axis);
    for (const int end : {0, 1}) {
        const Vec3 p = s.at(end == 0 ? from : to);
        const double separation = side * p[axis] - half[axis] - radius;
        if (separation > margin) continue;
        Vec3 onBox = p;
        onBox[axis] = side * half[axis];
        m.add(onBox, p - radius * m.normal, 1 + 2 * (2 * axis + (side > 0.0)) + end);
    }
    return true;
}

void onePoint(const Vec3& onBox, const Vec3& onCore, const Vec3& normal, double radius,
              Manifold& m) {
    m.normal = normal;
    m.add(onBox, onCore - radius * normal, 0);
}

Manifold coreOutside(const Segment& s, const Vec3& half, double radius, double margin, double t) {
    Manifold m;
    const Vec3 onCore = s.at(t), onBox = closestInBox(onCore, half);
    const Vec3 between = onCore - onBox;
    const double distance = between.norm();
    if (distance - radius > margin) return m;
    const Vec3 normal = between / distance;
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    const double side = normal[axis] < 0.0 ? -1.0 : 1.0;
    // Within 3 deg of the face, or so close that a wide margin includes the other end.
    const bool lies = std::abs(s.half[axis]) < larger(0.05 * s.half.norm(), 0.5 * margin);
    if (std::abs(normal[axis]) > 0.999 && lies &&
        alongFace(s, half, radius, margin, axis, side, m) && m.count > 0)
        return m;
    onePoint(onBox, onCore, normal, radius, m);
    return m;
}

Manifold coreInside(const Segment& s, const Vec3& half, double radius, double margin, double t) {
    Manifold m;
    const Axis best = leastPenetration(s, half);
    if (best.face) {
        int axis = 0;
        best.normal.cwiseAbs().maxCoeff(&axis);
        if (alongFace(s, half, radius, margin, axis, best.normal[axis] < 0.0 ? -1.0 : 1.0, m) &&
            m.count > 0)
            return m;
    }
    m.count = 0;
    const Vec3 onCore = s.at(t);
    onePoint(onCore - best.separation * best.normal, onCore, best.normal, radius, m);
    return m;
}

}  // namespace

Manifold collideBoxCapsule(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                           double margin) {
    const Segment world = coreOf(b, poseB);
    const Segment s{poseA.toLocal(world.centre), poseA.rotation.conjugate() * world.half};
    const double t = closestToBox(s, a.halfSize);
    const Vec3 p = s.at(t);
    const bool outside = (p - closestInBox(p, a.halfSize)).squaredNorm() > 1e-18;
    Manifold m = outside ? coreOutside(s, a.halfSize, b.radius, margin, t)
                         : coreInside(s, a.halfSize, b.radius, margin, t);
    m.normal = poseA.rotation * m.normal;
    for (int i = 0; i < m.count; ++i) {
        m.points[i].onA = poseA.toWorld(m.points[i].onA);
        m.points[i].onB = poseA.toWorld(m.points[i].onB);
    }
    return m;
}

}  // namespace engine
