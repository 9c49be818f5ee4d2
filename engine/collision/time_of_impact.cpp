#include "engine/collision/time_of_impact.h"

#include "engine/base/trigonometry.h"
#include "engine/collision/collide.h"
#include "engine/collision/collide_convex.h"
#include "engine/collision/oriented_box.h"

namespace engine {
namespace {

constexpr double kTouching = 5e-4;  // m: this close counts as touching
constexpr int kMostAdvances = 64;   // a pair that is so slow to come together touches

/// How far apart two shapes are (not positive: they touch), and for how long at least.
struct Gap {
    double distance = -kFar;  // m
    double time = 0.0;        // s; kFar: never
    double closing = 0.0;     // m/s, of the centres along the axis of the distance

    /// One direction n, from a to b, along which they are `apart`; the longest time counts.
    void see(const Vec3& n, double apart, const Motion& a, const Motion& b) {
        const double centres = (a.velocity - b.velocity).dot(n);
        if (apart > distance) distance = apart, closing = centres;
        if (apart <= 0.0) return;
        const double c =
            centres + a.spin.cross(n).norm() * a.reach + b.spin.cross(n).norm() * b.reach;
        time = larger(time, c > 0.0 ? apart / c : kFar);
    }
};

/// By all 15 axes: a pair that passes side by side is told apart at the first look.
Gap gapOfBoxes(const OrientedBox& boxA, const OrientedBox& boxB, const Motion& a,
               const Motion& b) {
    Gap gap;
    const Vec3 between = boxB.centre - boxA.centre;
    const auto see = [&](const Vec3& axis) {
        const double along = axis.dot(between);
        const Vec3 n = along < 0.0 ? Vec3(-axis) : axis;
        gap.see(n, std::abs(along) - boxA.extent(n) - boxB.extent(n), a, b);
    };
    for (int i = 0; i < 3; ++i) see(boxA.axes.col(i)), see(boxB.axes.col(i));
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const Vec3 axis = boxA.axes.col(i).cross(boxB.axes.col(j));
            const double length = axis.norm();
            if (length > 1e-3) see(axis / length);  // parallel edges: the faces cover them
        }
    return gap;
}

bool isConvex(const Piece& piece) {
    return piece.isTriangle || piece.shape->type > ShapeType::plane;
}

Gap gapAt(const Piece& pieceA, const Motion& a, const Piece& pieceB, const Motion& b,
          double time) {
    const Pose poseA = a.at(time), poseB = b.at(time);
    if (pieceA.isBox() && pieceB.isBox())
        return gapOfBoxes({*pieceA.shape, pieceA.at(poseA)}, {*pieceB.shape, pieceB.at(poseB)}, a,
                          b);
    Gap gap;
    const bool plane = pieceA.shape->type == ShapeType::plane ||
                       pieceB.shape->type == ShapeType::plane;
    if (!plane && (isConvex(pieceA) || isConvex(pieceB))) {
        const ConvexGap apart = gapOf(convexOf(pieceA, poseA), convexOf(pieceB, poseB));
        gap.see(apart.normal, apart.distance, a, b);
        return gap;
    }
    const Manifold m = collide(pieceA, poseA, pieceB, poseB, kFar);
    double apart = kFar;
    for (int i = 0; i < m.count; ++i) apart = smaller(apart, m.separation(i));
    gap.see(m.normal, apart, a, b);
    return gap;
}

}  // namespace

Pose Motion::at(double time) const {
    const double rate = spin.norm();
    const Vec3 place = start.position + time * velocity;
    if (rate == 0.0 || time == 0.0) return {place, start.rotation};
    Quat rotation = turnAbout(spin / rate, time * rate) * start.rotation;
    rotation.normalize();
    return {place, rotation};
}

Motion motionOf(const Bodies& bodies, int i, double dt) {
    const Shape& shape = bodies.defs[i].shape;
    Motion m{bodies.poses[i], bodies.velocities[i].linear, bodies.velocities[i].angular, 0.0,
             0.0};
    if (bodies.isDynamic(i)) m.velocity += 0.5 * dt * bodies.accelerations[i].linear;
    if (shape.type == ShapeType::capsule)
        m.reach = shape.halfLength;
    else if (shape.type != ShapeType::sphere)
        m.reach = reachOf(shape);
    m.sweep = m.spin.norm() * m.reach;
    return m;
}

double wayOf(const Motion& a, const Motion& b, double dt) {
    return dt * ((b.velocity - a.velocity).norm() + a.sweep + b.sweep);
}

Impact timeOfImpact(const Shape& shapeA, const Motion& a, const Shape& shapeB, const Motion& b,
                    double dt) {
    return timeOfImpact(wholeOf(shapeA), a, wholeOf(shapeB), b, dt);
}

Impact timeOfImpact(const Piece& pieceA, const Motion& a, const Piece& pieceB, const Motion& b,
                    double dt) {
    Impact closest{false, 0.0, kFar, 0.0};
    double time = 0.0;
    for (int i = 0; i < kMostAdvances; ++i) {
        const Gap gap = gapAt(pieceA, a, pieceB, b, time);
        if (gap.distance < closest.distance)
            closest = {false, time, gap.distance, gap.closing};
        closest.meets = gap.distance <= kTouching;
        if (closest.meets || time >= dt) return closest;
        time = smaller(time + gap.time, dt);
    }
    closest.meets = true;
    return closest;
}

}  // namespace engine
