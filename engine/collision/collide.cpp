#include "engine/collision/collide.h"

#include "engine/collision/collide_convex.h"

namespace engine {
namespace {

using Collide = Manifold (*)(const Shape&, const Pose&, const Shape&, const Pose&, double);

/// The row is the shape that comes first in ShapeType. Two planes never collide; later shapes are
/// handled by collide_convex.
constexpr int kShapes = 4;
constexpr Collide kCollide[kShapes][kShapes] = {
    {collideSphereSphere, collideSphereBox, collideSphereCapsule, collideSpherePlane},
    {nullptr, collideBoxBox, collideBoxCapsule, collideBoxPlane},
    {nullptr, nullptr, collideCapsuleCapsule, collideCapsulePlane},
    {nullptr, nullptr, nullptr, nullptr}};

Manifold collideAny(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                    double margin) {
    if (b.type == ShapeType::plane) return collideConvexPlane({a, poseA}, b, poseB, margin);
    if (a.type != ShapeType::plane) return collideConvex({a, poseA}, {b, poseB}, margin);
    Manifold m = collideConvexPlane({b, poseB}, a, poseA, margin);
    m.flip();
    return m;
}

}  // namespace

Manifold collide(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                 double margin) {
    const int i = static_cast<int>(a.type), j = static_cast<int>(b.type);
    if (i >= kShapes || j >= kShapes) return collideAny(a, poseA, b, poseB, margin);
    const Collide function = i <= j ? kCollide[i][j] : kCollide[j][i];
    if (!function) return {};
    if (i <= j) return function(a, poseA, b, poseB, margin);
    Manifold m = function(b, poseB, a, poseA, margin);
    m.flip();
    return m;
}

Manifold collide(const Piece& a, const Pose& bodyA, const Piece& b, const Pose& bodyB,
                 double margin) {
    if (!a.isTriangle && !b.isTriangle)
        return collide(*a.shape, a.at(bodyA), *b.shape, b.at(bodyB), margin);
    if (a.shape->type == ShapeType::plane || b.shape->type == ShapeType::plane) return {};
    return collideConvex(convexOf(a, bodyA), convexOf(b, bodyB), margin);
}

}  // namespace engine
