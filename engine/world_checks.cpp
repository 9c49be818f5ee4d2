#include "engine/world_checks.h"

#include <cmath>
#include <variant>

#include "engine/base/check.h"

namespace engine {
namespace {

bool isFinite(double x) { return std::isfinite(x); }
bool isFinite(const Vec3& v) { return v.allFinite(); }

template <class... Values>
bool areFinite(const Values&... values) {
    return (isFinite(values) && ...);
}
/// False for NaN.
bool isPositive(double x) { return x > 0.0 && std::isfinite(x); }
template <class... Numbers>
bool areNotNegative(Numbers... numbers) {
    return ((numbers >= 0.0 && std::isfinite(numbers)) && ...);
}
bool isWithin(int x, int least, int most) { return least <= x && x <= most; }
/// An enumerator, which a cast or memory that was not initialised may have made.
template <class Enum>
bool isOneOf(Enum value, Enum last) {
    return isWithin(static_cast<int>(value), 0, static_cast<int>(last));
}
bool isUnit(const Vec3& v) { return std::abs(v.norm() - 1.0) < 1e-6; }
bool areAcross(const Vec3& a, const Vec3& b) {
    return std::abs(a.dot(b)) < 1e-6 * a.norm() * b.norm();
}

/// The number of free coordinates of a type; a sixDof has all.
int coordinateCount(JointType type) {
    switch (type) {
        case JointType::weld:
        case JointType::lookAt:
        case JointType::gear:
            return 0;
        case JointType::distance:
        case JointType::hinge:
        case JointType::slider:
        case JointType::axis:
        case JointType::path:
            return 1;
        case JointType::ball:
        case JointType::universal:
        case JointType::constantVelocity:
        case JointType::wheel:
            return 2;
        case JointType::sixDof:
            return 6;
    }
    return 0;
}

void checkSpring(const Spring& s) {
    ENGINE_CHECK(
        areNotNegative(s.hz, s.damping, s.stiffness, s.resistance),
        "a spring's frequency, damping, stiffness and resistance must be finite and not negative");
}

void checkMaterial(const Material& m) {
    ENGINE_CHECK(areNotNegative(m.friction, m.rolling),
                 "friction and rolling resistance must be finite and not negative");
    ENGINE_CHECK(m.restitution >= 0.0 && m.restitution <= 1.0, "a restitution is within 0 and 1");
    ENGINE_CHECK(isOneOf(m.frictionRule, FrictionRule::larger), "there is no such friction rule");
}

/// A Shape may also be put together without its functions.
void checkShape(const Shape& s) {
    ENGINE_CHECK(isOneOf(s.type, ShapeType::mesh), "there is no such type of shape");
    ENGINE_CHECK(
        s.type != ShapeType::box || (s.halfSize.allFinite() && (s.halfSize.array() > 0.0).all()),
        "a box needs three positive edges; make it with Shape::box");
    ENGINE_CHECK(s.type != ShapeType::plane || isUnit(s.normal),
                 "a plane needs a unit normal; make it with Shape::plane");
    ENGINE_CHECK((s.type != ShapeType::hull || s.hull) &&
                     (s.type != ShapeType::compound || s.parts) &&
                     (s.type != ShapeType::mesh || s.mesh),
                 "make hulls, compounds and meshes with Shape::hullOf, compound and meshOf");
    ENGINE_CHECK(
        s.type == ShapeType::plane || (isPositive(reachOf(s)) && areNotNegative(s.halfLength)),
        "a shape needs positive, finite sizes; make it with a function of Shape");
}

void check(const ConstantForce& f) {
    ENGINE_CHECK(areFinite(f.force, f.torque, f.at),
                 "a force, its torque and its place must be finite");
}
void check(const Drag& f) {
    ENGINE_CHECK(areNotNegative(f.linear, f.angular), "drag must be finite and not negative");
}
void check(const Medium& f) {
    ENGINE_CHECK(areNotNegative(f.density, f.dragCoefficient),
                 "a medium's density and drag coefficient must be finite and not negative");
    ENGINE_CHECK(areFinite(f.velocity), "a medium's velocity must be finite");
    ENGINE_CHECK(!std::isnan(f.level) && (f.low.array() <= f.high.array()).all(),
                 "a medium's level must be a number, and its box must not end before it begins");
}
void check(const PointGravity& f) {
    ENGINE_CHECK(areFinite(f.centre, f.strength), "a point's place and pull must be finite");
    ENGINE_CHECK(areNotNegative(f.softening), "a softening length must be finite and not negative");
}
void check(const NBodyGravity& f) {
    ENGINE_CHECK(areFinite(f.constant), "the constant of gravity must be finite");
    ENGINE_CHECK(areNotNegative(f.softening), "a softening length must be finite and not negative");
}
void check(const SpringForce& f) {
    ENGINE_CHECK(areFinite(f.anchorA, f.anchorB), "a spring's ends must be finite");
    ENGINE_CHECK(areNotNegative(f.length, f.stiffness, f.damping),
                 "a spring's length, stiffness and damping must be finite and not negative");
}
void check(const Airfoil& f) {
    ENGINE_CHECK(areFinite(f.at, f.wind), "an airfoil's place and wind must be finite");
    ENGINE_CHECK(isUnit(f.chord) && isUnit(f.normal) && areAcross(f.chord, f.normal),
                 "an airfoil's chord and normal must be unit vectors at right angles");
    ENGINE_CHECK(
        areNotNegative(f.area, f.density, f.liftSlope, f.stall, f.profileDrag, f.plateDrag) &&
            isPositive(f.aspect),
        "an airfoil's numbers must be finite and not negative, its aspect positive");
}

}  // namespace

void checkIdle(const WorldState& s) {
    ENGINE_CHECK(!s.calling,
                 "a force field or observer may only read its world; change it between two steps");
}

void checkSettings(const Settings& s) {
    ENGINE_CHECK(s.substeps >= 1 && s.sweeps >= 0 && s.nudges >= 0,
                 "a step needs at least one sub-step, and sweeps and nudges must not be negative");
    ENGINE_CHECK(
        isWithin(s.substeps, 1, kMostSubsteps) && isWithin(s.maxSubsteps, 1, kMostSubsteps),
        "a step has 1 to 10000 sub-steps");
    ENGINE_CHECK(isWithin(s.sweeps, 0, kMostSweeps) && isWithin(s.minSweeps, 0, kMostSweeps) &&
                     isWithin(s.movingSweeps, 0, kMostSweeps) && isWithin(s.nudges, 0, kMostSweeps),
                 "a sub-step has 0 to 1000000 sweeps and nudges");
    ENGINE_CHECK(isWithin(s.restFactor, 1, kMostSweeps),
                 "restFactor multiplies sweeps: use 1 for no more of them");
    ENGINE_CHECK(s.baumgarte == 0.0 || s.nudges == 0,
                 "use Baumgarte or nudges for one error, never both");
    ENGINE_CHECK(areNotNegative(s.tolerance, s.nudgeFactor, s.baumgarte, s.depenetrationSpeed,
                                s.slop, s.bounceSpeed, s.speculativeMargin),
                 "tolerance, factors, speeds, slop and margin must be finite and not negative");
    ENGINE_CHECK(isPositive(s.sleepAfter), "sleepAfter must be positive");
    ENGINE_CHECK(isWithin(s.threads, 1, kMostThreads),
                 "a step needs at least one thread, at most 256");
    ENGINE_CHECK(isOneOf(s.method, Method::direct) && isOneOf(s.order, Order::pairs) &&
                     isOneOf(s.joints, JointSolving::rows) &&
                     isOneOf(s.gyroscope, Gyroscope::none) && isOneOf(s.bounce, Bounce::bias) &&
                     isOneOf(s.springs, Springs::implicit) &&
                     isOneOf(s.instructions, Instructions::baseline),
                 "there is no such method; see Settings");
}

void checkPose(const Pose& pose) {
    ENGINE_CHECK(pose.position.allFinite(), "a position must be finite");
    const double length = pose.rotation.norm();
    ENGINE_CHECK(isPositive(length), "a rotation needs a nonzero quaternion, all of it finite");
}

void checkBody(const BodyDef& def) {
    ENGINE_CHECK(isOneOf(def.kind, BodyKind::kinematic), "there is no such kind of body");
    checkPose(def.pose);
    checkShape(def.shape);
    checkMaterial(def.material);
    ENGINE_CHECK(areFinite(def.velocity, def.spin), "a velocity and a spin must be finite");
    ENGINE_CHECK(def.kind != BodyKind::dynamic ||
                     (def.mass ? isPositive(*def.mass) : isPositive(def.material.density)),
                 "a dynamic body needs a positive mass or density");
    ENGINE_CHECK(!def.inertia || def.inertia->allFinite(), "an inertia tensor must be finite");
}

void checkFreedom(JointType type, int coordinate, const Freedom& f) {
    ENGINE_CHECK(isWithin(coordinate, 0, 5), "a joint has coordinates 0 to 5");
    ENGINE_CHECK(!f.acts() || coordinate < coordinateCount(type),
                 "this type of joint has no such coordinate; see JointType");
    ENGINE_CHECK(!f.acts() || type != JointType::constantVelocity || coordinate == 1,
                 "a constant velocity joint holds its twist; its swing is coordinate 1");
    ENGINE_CHECK(!f.locked || (type == JointType::sixDof && !f.acts()),
                 "only a sixDof can lock coordinates, and nothing else may act along a locked one");
    ENGINE_CHECK(f.limits.low <= f.limits.high, "a lower limit must not exceed the upper one");
    ENGINE_CHECK(f.motor.strength >= 0.0,
                 "a motor's strength must not be negative; reverse its speed");
    ENGINE_CHECK(areFinite(f.motor.speed, f.rest),
                 "a motor's speed and a spring's rest must be finite");
    checkSpring(f.spring);
    ENGINE_CHECK(areNotNegative(f.inertia), "a rotor's inertia must be finite and not negative");
}

void checkJoint(const WorldState& s, const JointDef& def) {
    ENGINE_CHECK(isOneOf(def.type, JointType::path), "there is no such type of joint");
    ENGINE_CHECK(def.a != def.b, "a joint needs two different bodies");
    ENGINE_CHECK(s.bodies.isDynamic(def.a.index) || s.bodies.isDynamic(def.b.index),
                 "one of a joint's bodies must be dynamic");
    ENGINE_CHECK(areFinite(def.anchorA, def.anchorB, def.axis, def.axis2, def.ratio),
                 "a joint's anchors, axes and ratio must be finite");
    ENGINE_CHECK(areNotNegative(def.length), "a joint's length must be finite and not negative");
    ENGINE_CHECK(def.type != JointType::distance || def.length > 0.0 || rowCount(def) == 0,
                 "a distance joint needs a positive length; for zero use a ball joint");
    ENGINE_CHECK(def.axis.norm() > 0.0,
                 "a joint's axis must not be zero; keep the default if unused");
    ENGINE_CHECK((def.type != JointType::universal && def.type != JointType::wheel) ||
                     (!def.axis2.isZero(0.0) && areAcross(def.axis, def.axis2)),
                 "the axes of a universal joint or a wheel must be at right angles");
    ENGINE_CHECK(def.type != JointType::gear || def.ratio != 0.0,
                 "a gear's ratio must not be zero");
    ENGINE_CHECK(def.type != JointType::path || def.path.size() >= 2,
                 "a path needs at least two points");
    for (const Vec3& point : def.path)
        ENGINE_CHECK(point.allFinite(), "a path's points must be finite");
    ENGINE_CHECK(def.breakForce > 0.0 && def.breakTorque > 0.0,
                 "breakForce and breakTorque must be positive");
    checkSpring(def.spring);
    for (int i = 0; i < 6; ++i) checkFreedom(def.type, i, def.free[i]);
}

void checkForce(const ForceDef& def) {
    ENGINE_CHECK(!std::holds_alternative<SpringForce>(def.kind) || def.on.size() == 2,
                 "a spring has two ends: put both bodies in `on`");
    ENGINE_CHECK(!std::holds_alternative<SpringForce>(def.kind) || def.on[0] != def.on[1],
                 "a spring needs two different bodies");
    ENGINE_CHECK(def.from <= def.until, "a force must not end before it begins");
    std::visit([](const auto& kind) { check(kind); }, def.kind);
}

}  // namespace engine
