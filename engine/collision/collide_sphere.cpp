/// Sphere against other shapes: one point, on the line from the centre to the closest point.
#include "engine/collision/collide.h"
#include "engine/collision/segment.h"

namespace engine {
namespace {

/// Two balls around `a` and `b`: c = |b - a| - ra - rb. Concentric balls are separated along y.
Manifold ballAgainstBall(const Vec3& a, double ra, const Vec3& b, double rb, double margin) {
    Manifold m;
    const Vec3 between = b - a;
    const double distance = between.norm();
    if (distance - ra - rb > margin) return m;
    m.normal = distance > 0.0 ? Vec3(between / distance) : Vec3(Vec3::UnitY());
    m.add(a + ra * m.normal, b - rb * m.normal, 0);
    return m;
}

/// Centre inside the box: out through the nearest face.
Manifold ballInsideBox(const Shape& ball, const Pose& poseA, const Shape& box, const Pose& poseB,
                       const Vec3& local) {
    const Vec3 depth = box.halfSize - local.cwiseAbs();
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (depth[i] < depth[axis]) axis = i;
    const double side = local[axis] < 0.0 ? -1.0 : 1.0;
    Vec3 surface = local;
    surface[axis] = side * box.halfSize[axis];
    Manifold m;
    m.normal = poseB.rotation * Vec3(-side * Vec3::Unit(axis));
    m.add(poseA.position + ball.radius * m.normal, poseB.toWorld(surface), 0);
    return m;
}

}  // namespace

Manifold collideSphereSphere(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                             double margin) {
    return ballAgainstBall(poseA.position, a.radius, poseB.position, b.radius, margin);
}

Manifold collideSphereCapsule(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                              double margin) {
    const Segment core = coreOf(b, poseB);
    return ballAgainstBall(poseA.position, a.radius, core.at(closestOn(core, poseA.position)),
                           b.radius, margin);
}

Manifold collideSphereBox(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                          double margin) {
    const Vec3 local = poseB.toLocal(poseA.position);
    const Vec3 closest = local.cwiseMax(-b.halfSize).cwiseMin(b.halfSize);
    if (closest == local) return ballInsideBox(a, poseA, b, poseB, local);
    return ballAgainstBall(poseA.position, a.radius, poseB.toWorld(closest), 0.0, margin);
}

Manifold collideSpherePlane(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                            double margin) {
    Manifold m;
    const Vec3 up = poseB.rotation * b.normal;
    const double height = up.dot(poseA.position - poseB.position);
    if (height - a.radius > margin) return m;
    m.normal = -up;
    m.add(poseA.position - a.radius * up, poseA.position - height * up, 0);
    return m;
}

}  // namespace engine
