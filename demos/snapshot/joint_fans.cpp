#include "demos/snapshot/joint_fans.h"

#include "demos/snapshot/coil.h"
#include "demos/snapshot/colors.h"
#include "engine/base/trigonometry.h"
#include "render/palette.h"

namespace demos {
namespace {

using engine::JointState;
using engine::kPi;
using engine::larger;
using engine::Limits;
using engine::smaller;

/// The drawing of an angle about an axis.
struct Fan {
    Vec3 at{0, 0, 0};     // m
    Vec3 axis{0, 0, 1};   // unit
    Vec3 zero{1, 0, 0};   // unit, perpendicular to the axis: angle 0. Fixed in a, like the limits
    double angle = 0.0;   // rad, the current angle of b
    double length = 0.0;  // m

    Vec3 rim(double radians) const {
        return at + length * (engine::turnAbout(axis, radians) * zero);
    }
};

/// Perpendicular to the axis, and fixed in the body that the axis is fixed in.
Vec3 acrossIn(const Quat& body, const Vec3& axis) {
    const Vec3 local = body.conjugate() * axis, across = local.cross(Vec3::UnitX());
    return body * (across.norm() > 0.1 ? across : Vec3(local.cross(Vec3::UnitY()))).normalized();
}

void addHand(const Fan& fan, render::Frame& frame) {
    addLine(fan.at, fan.rim(fan.angle), kArcPixels, render::normalColor(), frame);
}

/// Draws the limits and the arc between them.
void addArc(const Fan& fan, const Limits& limits, render::Frame& frame) {
    if (!limits.any()) return;
    const double turn = 2.0 * kPi;  // more is drawn as a full circle
    const double low = larger(limits.low, fan.angle - turn);
    const double high = smaller(limits.high, fan.angle + turn);
    constexpr int kSteps = 24;
    const auto rim = [&](int i) { return fan.rim(low + (high - low) * i / kSteps); };
    for (int i = 0; i < kSteps; ++i)
        addLine(rim(i), rim(i + 1), kArcPixels, render::frictionColor(), frame);
    for (const double limit : {limits.low, limits.high})
        if (std::isfinite(limit))
            addLine(fan.at, fan.rim(limit), kAxisPixels, render::frictionColor(), frame);
}

void addLimitedAngle(const Fan& fan, const Limits& limits, render::Frame& frame) {
    if (!limits.any()) return;
    addHand(fan, frame);
    addArc(fan, limits, frame);
}

/// The directions at an angle of `swing` to the axis: a ring with four spokes; `zero` is
/// perpendicular to the axis.
void addCone(const Fan& cone, double swing, render::Frame& frame) {
    if (swing <= 0.0 || swing >= kPi) return;  // no direction is excluded
    Fan ring = cone;
    ring.at += engine::cosine(swing) * cone.length * cone.axis;
    ring.length *= engine::sine(swing);
    constexpr int kSteps = 48;
    const auto rim = [&](int i) { return ring.rim(2.0 * kPi * i / kSteps); };
    for (int i = 0; i < kSteps; ++i) {
        addLine(rim(i), rim(i + 1), kArcPixels, render::frictionColor(), frame);
        if (i % (kSteps / 4) == 0)
            addLine(cone.at, rim(i), kAxisPixels, render::frictionColor(), frame);
    }
}

/// m: the upper limit; without one, a point beyond b.
double upperEnd(const Limits& limits, double position, double size) {
    return std::isfinite(limits.high) ? limits.high : larger(position, 0.0) + size;
}

/// A line from limit to limit along `way`, through b, with ticks at the limits.
void addLimitedWay(const JointState& joint, int coordinate, const Vec3& way, const Vec3& across,
                   double size, render::Frame& frame) {
    const Limits& limits = joint.def.free[coordinate].limits;
    if (!limits.any()) return;
    const double position = joint.positions[coordinate];
    const auto at = [&](double x) { return Vec3(joint.worldB + (x - position) * way); };
    addLine(at(std::isfinite(limits.low) ? limits.low : smaller(position, 0.0) - size),
            at(upperEnd(limits, position, size)), kArcPixels, render::frictionColor(), frame);
    const Vec3 tick = 0.1 * size * across;
    for (const double limit : {limits.low, limits.high})
        if (std::isfinite(limit))
            addLine(at(limit) - tick, at(limit) + tick, kAxisPixels, render::frictionColor(),
                    frame);
}

}  // namespace

void addHingeAngle(const Stage& stage, const JointState& joint, double size, render::Frame& frame) {
    const Vec3& axis = joint.worldAxis;
    Fan fan{joint.worldB, axis, acrossIn(stage.world.pose(joint.def.a).rotation, axis),
            joint.position, 0.8 * size};
    Vec3 toCentre = stage.world.pose(joint.def.b).position - joint.worldB;
    toCentre -= axis.dot(toCentre) * axis;
    if (toCentre.norm() > 1e-3 * size)  // then the hand points to the centre
        fan.zero = engine::turnAbout(axis, -joint.position) * toCentre.normalized();
    addHand(fan, frame);
    addArc(fan, joint.def.free[0].limits, frame);
}

void addSwingAndTwist(const Stage& stage, const JointState& joint, double size,
                      render::Frame& frame) {
    const Limits &twist = joint.def.free[0].limits, &swing = joint.def.free[1].limits;
    if (!twist.any() && !swing.any()) return;
    const Vec3 &axis = joint.worldAxis, &at = joint.worldA;
    const Fan fan{at, axis, acrossIn(stage.world.pose(joint.def.a).rotation, axis),
                  joint.positions[0], size};
    addLine(at, at + size * axis, kAxisPixels, render::jointColor(), frame);
    addLine(at, at + size * joint.worldAxis2, kArcPixels, render::normalColor(), frame);
    addCone(fan, swing.low, frame);
    addCone(fan, swing.high, frame);
    Fan twisted = fan;
    twisted.length *= 0.5;  // inside the cone, but not part of it
    addLimitedAngle(twisted, twist, frame);
}

void addUniversalAngles(const JointState& joint, double size, render::Frame& frame) {
    // The first angle is that of axis2 about `axis`; the second is that of b's first pin about
    // axis2, starting at a's.
    const Vec3 &axis = joint.worldAxis, &axis2 = joint.worldAxis2;
    const Vec3 first = engine::turnAbout(axis, -joint.positions[0]) * axis2;
    const Vec3 second = (axis - axis2.dot(axis) * axis2).normalized();
    addLimitedAngle({joint.worldB, axis, first, joint.positions[0], 0.8 * size},
                    joint.def.free[0].limits, frame);
    addLimitedAngle({joint.worldB, axis2, second, joint.positions[1], 0.8 * size},
                    joint.def.free[1].limits, frame);
}

void addSixDof(const JointState& joint, double size, render::Frame& frame) {
    const Vec3 ways[] = {joint.worldAxis, joint.worldAxis2A,
                         joint.worldAxis.cross(joint.worldAxis2A)};
    for (int i = 0; i < 3; ++i) {
        const Vec3 &way = ways[i], &next = ways[(i + 1) % 3];
        addLine(joint.worldA, joint.worldA + size * way, kAxisPixels, axisColor(i), frame);
        addLimitedWay(joint, i, way, next, size, frame);
        addLimitedAngle({joint.worldB, way, next, joint.positions[3 + i], 0.8 * size},
                        joint.def.free[3 + i].limits, frame);
    }
}

void addSuspension(const JointState& joint, double size, render::Frame& frame) {
    addLimitedWay(joint, 0, joint.worldAxis, joint.worldAxis2, size, frame);
    const engine::Freedom& way = joint.def.free[0];
    if (!way.spring.isSoft()) return;
    const double high = upperEnd(way.limits, joint.position, size);
    const Vec3 top = joint.worldB + (high - joint.position) * joint.worldAxis;
    // Lines, because the spring of most cars is inside the wheel, and lines are visible through it.
    render::Frame coil;
    coil.camera = frame.camera;
    addCoil(drawn(top), drawn(joint.worldB), static_cast<float>(size), 0, coil);
    for (const render::Rod& rod : coil.rods)
        frame.lines.push_back({rod.from, rod.to, 1.5f, render::jointColor()});
}

}  // namespace demos
