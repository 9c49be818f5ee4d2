/// Shape against shape. Every function finds the points whose separation is at most `margin`, so
/// that the solver sees a contact before it is too late; none found leaves count = 0.
#pragma once
#include "engine/collision/manifold.h"
#include "engine/collision/pieces.h"
#include "engine/shape.h"

namespace engine {

/// Any shape but compounds and meshes (pieces.h) against any other; the normal points from a to b.
Manifold collide(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                 double margin);

Manifold collideSphereSphere(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                             double margin);
Manifold collideSphereBox(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                          double margin);
Manifold collideSphereCapsule(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                              double margin);
Manifold collideSpherePlane(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                            double margin);
Manifold collideBoxBox(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                       double margin);
/// The best pair of faces, also where two edges are nearer: what comes down when the boxes turn about
/// those. Every point found deep is so, because it lies within the other's sides.
Manifold collideBoxFaces(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                         double margin);
Manifold collideBoxCapsule(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                           double margin);
Manifold collideBoxPlane(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                         double margin);
Manifold collideCapsuleCapsule(const Shape& a, const Pose& poseA, const Shape& b,
                               const Pose& poseB, double margin);
Manifold collideCapsulePlane(const Shape& a, const Pose& poseA, const Shape& b, const Pose& poseB,
                             double margin);

}  // namespace engine
