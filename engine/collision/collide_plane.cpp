/// Box and capsule against a plane: their corners and ends.
#include "engine/collision/collide.h"
#include "engine/collision/segment.h"

namespace engine {

Manifold collideBoxPlane(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                         double margin) {
    const Vec3 up = poseB.rotation * b.normal;
    const Vec3 upLocal = poseA.rotation.conjugate() * up;
    // The lowest face contains the lowest corner and its neighbours. Its four corners are enough,
    // and because they belong to one face they are found again in the next step.
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(upLocal[i]) > std::abs(upLocal[axis]) + 1e-3) axis = i;
    const double side = upLocal[axis] > 0.0 ? -1.0 : 1.0;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Manifold m;
    m.normal = -up;
    // Corners in a ring; the feature is the corner's number, one bit per axis.
    constexpr double kRing[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (const auto& sign : kRing) {
        Vec3 corner;
        corner[axis] = side, corner[u] = sign[0], corner[v] = sign[1];
        const int feature = (corner.x() > 0) + 2 * (corner.y() > 0) + 4 * (corner.z() > 0);
        const Vec3 p = poseA.toWorld(corner.cwiseProduct(a.halfSize));
        const double height = up.dot(p - poseB.position);
        if (height <= margin) m.add(p, p - height * up, feature);
    }
    return m;
}

Manifold collideCapsulePlane(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                             double margin) {
    const Vec3 up = poseB.rotation * b.normal;
    const Segment core = coreOf(a, poseA);
    Manifold m;
    m.normal = -up;
    for (const int end : {0, 1}) {
        const Vec3 p = core.at(end == 0 ? -1.0 : 1.0);
        const double height = up.dot(p - poseB.position);
        if (height - a.radius <= margin) m.add(p - a.radius * up, p - height * up, end);
    }
    return m;
}

}  // namespace engine
