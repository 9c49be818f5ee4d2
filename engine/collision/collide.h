/// Shape against shape. Every function finds the points whose separation is at most `margin`, so that the
/// solver knows a contact before it is too late. If there are none, count is 0.
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
/// The contact of the best pair of faces, even where two edges are nearer: it holds the features that come
/// down when the boxes turn about those edges. Every point found to be deep really is, because it lies within
/// the other's sides.
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
