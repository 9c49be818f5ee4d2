#include "engine/collision/collide.h"

namespace engine {
namespace {

using Collide = Manifold (*)(const Shape&, const Pose&, const Shape&, const Pose&, double);

/// Row: the shape that comes first in ShapeType. Two planes never meet.
constexpr int kShapes = 4;
constexpr Collide kCollide[kShapes][kShapes] = {
    {collideSphereSphere, collideSphereBox, collideSphereCapsule, collideSpherePlane},
    {nullptr, collideBoxBox, collideBoxCapsule, collideBoxPlane},
    {nullptr, nullptr, collideCapsuleCapsule, collideCapsulePlane},
    {nullptr, nullptr, nullptr, nullptr}};

}  // namespace

Manifold collide(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                 double margin) {
    const int i = static_cast<int>(a.type), j = static_cast<int>(b.type);
    const Collide function = i <= j ? kCollide[i][j] : kCollide[j][i];
    if (!function) return {};
    if (i <= j) return function(a, poseA, b, poseB, margin);
    Manifold m = function(b, poseB, a, poseA, margin);
    m.flip();
    return m;
}

}  // namespace engine
