#include "engine/collision/time_of_impact.h"

#include "engine/base/trigonometry.h"
#include "engine/collision/collide.h"
#include "engine/collision/collide_convex.h"
#include "engine/collision/oriented_box.h"

namespace engine {
namespace {

constexpr double kTouching = 5e-4;  // m: this close counts as touching,
constexpr double kTouchingShare = 0.01;  // and at most this share of the smaller one's size
constexpr int kMostAdvances = 64;   // a pair not finished after so many touches

/// The motion of the larger body near the smaller one (time_of_impact.h).
struct Passing {
    bool any = false;               // it turns slowly enough for a tighter bound
    Vec3 velocity = Vec3::Zero();   // m/s, of its point at the other's centre, relative to the other
    double reach = 0.0;             // m: r'
};

Passing passingOf(const Motion& large, const Vec3& centre, const Motion& small,
                  const Vec3& smallCentre, double left) {
    constexpr double kLarger = 2.0;  // times the size: below it, nothing is gained
    if (large.size < kLarger * small.size) return {};
    const double rate = large.spin.norm();
    if (!(rate * left < 0.5) || rate == 0.0) return {};
    const Vec3 between = large.velocity - small.velocity;
    const Vec3 velocity = between + large.spin.cross(smallCentre - centre);
    // Going back in time, a point's distance grows by at most e^(rate left) < 1 / (1 - rate left).
    const double from = (small.size + left * velocity.norm()) / (1.0 - rate * left);
    return {true, velocity, from + left * between.norm()};
}

/// The motion of two bodies from `now` (s) on, for `left` (s).
class Approach {
public:
    Approach(const Motion& a, const Motion& b, double now, double left)
        : a_(a), b_(b), now_(now), left_(left), byA_(a.size > b.size) {
        const Motion &large = byA_ ? a : b, &small = byA_ ? b : a;
        passing_ = passingOf(large, large.placeAt(now), small, small.placeAt(now), left);
    }
    double left() const { return left_; }
    double now() const { return now_; }
    const Motion& a() const { return a_; }
    const Motion& b() const { return b_; }
    /// k: the most that rotation accelerates points towards the other body, m/s^2.
    double mostTurning() const {
        return a_.spin.squaredNorm() * a_.reach + b_.spin.squaredNorm() * b_.reach;
    }
    /// The approach of the centres along n, from a to b, m/s.
    double ofCentres(const Vec3& n) const { return (a_.velocity - b_.velocity).dot(n); }
    /// c: the fastest approach of any points that may meet, m/s.
    double mostAlong(const Vec3& n) const {
        const double turnA = a_.spin.cross(n).norm(), turnB = b_.spin.cross(n).norm();
        const double all = ofCentres(n) + turnA * a_.reach + turnB * b_.reach;
        if (!passing_.any) return all;
        const double local =
            byA_ ? passing_.velocity.dot(n) + turnA * passing_.reach + turnB * b_.reach
                 : -passing_.velocity.dot(n) + turnB * passing_.reach + turnA * a_.reach;
        return smaller(all, local);
    }

private:
    const Motion &a_, &b_;
    double now_, left_;
    bool byA_;
    Passing passing_;
};

/// The distance of two shapes (<= 0: they touch), and how long they stay apart at least.
struct Gap {
    double distance = -kFar;  // m
    double time = 0.0;        // s; kFar: never
    double closing = 0.0;     // m/s, of the centres along the axis of the distance
    double least = -kFar;     // m: a lower bound of the distance in the time left

    /// Adds a direction n, from a to b, along which they are `apart`. The longest time counts.
    void see(const Vec3& n, double apart, const Approach& approach) {
        if (apart > distance) distance = apart, closing = approach.ofCentres(n);
        if (apart <= 0.0) return;
        const double c = approach.mostAlong(n);
        time = larger(time, c > 0.0 ? apart / c : kFar);
        least = larger(least, apart - approach.left() * larger(c, 0.0));
    }
};

/// The height along n (m) to which the points of a core come at present speeds after `left` (s).
double heightAfter(const Convex& piece, const Motion& motion, double now, double left,
                   const Vec3& n) {
    const Vec3 centre = motion.placeAt(now), d = n + left * n.cross(motion.spin);
    return n.dot(centre + left * motion.velocity) + d.dot(piece.support(d) - centre);
}

/// The bound by the points' own speeds along n, where the two are `apart` (m).
void seePoints(const Convex& a, const Convex& b, const Vec3& n, double apart,
               const Approach& approach, Gap& gap) {
    const double left = approach.left(), k = approach.mostTurning();
    if (apart <= 0.0 || left <= 0.0) return;
    const double heightOfA = heightAfter(a, approach.a(), approach.now(), left, n),
                 depthOfB = heightAfter(b, approach.b(), approach.now(), left, -n);
    const double linear = -depthOfB - heightOfA - a.radius() - b.radius();
    const double last = linear - 0.5 * k * left * left, rate = (linear - apart) / left;
    gap.least = larger(gap.least, smaller(apart, last));
    const double root = std::sqrt(rate * rate + 2.0 * k * apart);
    const double zero = rate < 0.0 ? 2.0 * apart / (root - rate) : (root + rate) / k;
    gap.time = larger(gap.time, last > 0.0 ? kFar : zero);
}

/// Tests all 15 axes, so a pair that passes side by side is separated in the first iteration. Omits the edges
/// if the faces show that they stay farther apart than `near` (m).
Gap gapOfBoxes(const OrientedBox& boxA, const OrientedBox& boxB, const Approach& approach,
               double near) {
    Gap gap;
    const Vec3 between = boxB.centre - boxA.centre;
    const auto see = [&](const Vec3& axis) {
        const double along = axis.dot(between);
        const Vec3 n = along < 0.0 ? Vec3(-axis) : axis;
        gap.see(n, std::abs(along) - boxA.extent(n) - boxB.extent(n), approach);
    };
    for (int i = 0; i < 3; ++i) {
        see(boxA.axes.col(i)), see(boxB.axes.col(i));
        if (gap.least > near) return gap;
    }
    const EdgeAxes edges(boxA, boxB);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            if (!edges.mayExceed(gap.distance, i, j)) continue;
            const Vec3 axis = boxA.axes.col(i).cross(boxB.axes.col(j));
            const double length = axis.norm();
            if (length > 1e-3) see(axis / length);  // parallel edges: the faces cover them
        }
    return gap;
}

bool isConvex(const Piece& piece) {
    return piece.isTriangle || piece.shape->type > ShapeType::plane;
}

/// Whether a triangle and another piece are certainly farther apart than `enough` (m): most are.
bool isClear(const Convex& a, const Convex& b, double enough) {
    if (a.isTriangle()) return apartFromTriangle(a, b) > enough;
    return b.isTriangle() && apartFromTriangle(b, a) > enough;
}

Gap gapOfConvex(const Convex& a, const Convex& b, const Approach& approach, double near,
                double enough) {
    if (approach.now() == 0.0 && isClear(a, b, enough)) return {kFar, kFar, 0.0, kFar};
    const ConvexGap apart = gapOf(a, b, enough);
    Gap gap;
    gap.see(apart.normal, apart.distance, approach);
    if (gap.least <= near && apart.distance < kFar)
        seePoints(a, b, apart.normal, apart.distance, approach, gap);
    return gap;
}

/// Not exact where they stay farther apart than `near` (m), as they do if their distance exceeds `enough`
/// (m).
Gap gapAt(const Piece& pieceA, const Pose& poseA, const Piece& pieceB, const Pose& poseB,
          const Approach& approach, double near, double enough) {
    if (pieceA.isBox() && pieceB.isBox())
        return gapOfBoxes({*pieceA.shape, pieceA.at(poseA)}, {*pieceB.shape, pieceB.at(poseB)},
                          approach, near);
    const bool plane = pieceA.shape->type == ShapeType::plane ||
                       pieceB.shape->type == ShapeType::plane;
    if (!plane && (isConvex(pieceA) || isConvex(pieceB)))
        return gapOfConvex(convexOf(pieceA, poseA), convexOf(pieceB, poseB), approach, near,
                           enough);
    const Manifold m = collide(pieceA, poseA, pieceB, poseB, kFar);
    double apart = kFar;
    for (int i = 0; i < m.count; ++i) apart = smaller(apart, m.separation(i));
    Gap gap;
    gap.see(m.normal, apart, approach);
    return gap;
}

}  // namespace

Pose Motion::at(double time) const {
    const Vec3 place = placeAt(time);
    const double rate = time == 0.0 ? 0.0 : spin.norm();
    if (rate == 0.0) return {place, start.rotation};
    Quat rotation = turnAbout(spin / rate, time * rate) * start.rotation;
    rotation.normalize();
    return {place, rotation};
}

Motion motionOf(const Bodies& bodies, int i, double dt) {
    const Shape& shape = bodies.defs[i].shape;
    Motion m{bodies.poses[i], bodies.velocities[i].linear, bodies.velocities[i].angular, 0.0,
             0.0};
    if (bodies.isDynamic(i)) m.velocity += 0.5 * dt * bodies.accelerations[i].linear;
    if (shape.type != ShapeType::plane) m.size = reachOf(shape);
    if (shape.type == ShapeType::capsule)
        m.reach = shape.halfLength;
    else if (shape.type != ShapeType::sphere && shape.type != ShapeType::plane)
        m.reach = m.size;
    m.sweep = m.spin.norm() * m.reach;
    return m;
}

double wayOf(const Motion& a, const Motion& b, double dt) {
    const double all = dt * ((b.velocity - a.velocity).norm() + a.sweep + b.sweep);
    const bool byA = a.size > b.size;
    const Motion &large = byA ? a : b, &small = byA ? b : a;
    const Passing passing =
        passingOf(large, large.start.position, small, small.start.position, dt);
    if (!passing.any) return all;
    return smaller(all, dt * (passing.velocity.norm() + large.spin.norm() * passing.reach +
                              small.sweep));
}

Impact timeOfImpact(const Shape& shapeA, const Motion& a, const Shape& shapeB, const Motion& b,
                    double dt, double near) {
    return timeOfImpact(wholeOf(shapeA), a, wholeOf(shapeB), b, dt, near);
}

Impact timeOfImpact(const Piece& pieceA, const Motion& a, const Piece& pieceB, const Motion& b,
                    double dt, double near) {
    Impact closest{false, 0.0, kFar, 0.0};
    const double enough = near + wayOf(a, b, dt);
    const double touching = smaller(kTouching, kTouchingShare * smaller(a.size, b.size));
    double time = 0.0;
    for (int i = 0; i < kMostAdvances; ++i) {
        const Gap gap = gapAt(pieceA, a.at(time), pieceB, b.at(time), {a, b, time, dt - time}, near,
                              enough);
        if (gap.distance < closest.distance)
            closest = {false, time, gap.distance, gap.closing};
        closest.meets = gap.distance <= touching;
        if (closest.meets || time >= dt || gap.least > near || gap.least >= closest.distance)
            return closest;
        time = smaller(time + gap.time, dt);
    }
    closest.meets = true;
    return closest;
}

}  // namespace engine
