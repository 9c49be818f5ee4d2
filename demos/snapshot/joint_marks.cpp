// --show joints: anchors, axes, where the angle stands between its limits.
#include "demos/snapshot/parts.h"
#include "engine/base/trigonometry.h"
#include "render/palette.h"

namespace demos {
namespace {

using engine::JointState;
using engine::JointType;
using engine::larger;
using engine::smaller;

constexpr float kAxisPixels = 2.0f, kArcPixels = 2.5f;

void addAnchor(const Stage& stage, engine::BodyId body, const Vec3& at, float pixels,
               const render::Color& color, render::Frame& frame) {
    render::Marker marker{drawn(at), pixels, color};
    if (body != stage.ground)
        marker.reach = static_cast<float>(2.0 * reachOf(stage.world.def(body).shape));
    frame.markers.push_back(marker);
}

void addLine(const Vec3& from, const Vec3& to, float pixels, const render::Color& color,
             render::Frame& frame) {
    frame.lines.push_back({drawn(from), drawn(to), pixels, color});
}

/// m: how far marks reach, by the smaller of the two bodies.
double sizeOf(const Stage& stage, const JointState& joint) {
    double size = 0.0;
    for (const engine::BodyId body : {joint.def.a, joint.def.b}) {
        const double reach = body == stage.ground ? 0.0 : reachOf(stage.world.def(body).shape);
        if (reach > 0.0) size = size > 0.0 ? smaller(size, reach) : reach;
    }
    return 1.2 * size;
}

void addAxis(const Vec3& at, const Vec3& axis, double size, render::Frame& frame) {
    addLine(at - size * axis, at + size * axis, kAxisPixels, render::jointColor(), frame);
}

/// A fan from the axis: the limits and what lies between, and a hand that shows where b stands.
void addAngle(const Stage& stage, const JointState& joint, double size, render::Frame& frame) {
    const engine::Limits& limits = joint.def.free[0].limits;
    const Vec3 &axis = joint.worldAxis, &at = joint.worldB;
    Vec3 hand = stage.world.pose(joint.def.b).position - at;
    hand -= axis.dot(hand) * axis;
    Vec3 other = axis.cross(Vec3::UnitX());
    if (hand.norm() < 1e-3 * size) hand = other.norm() > 0.1 ? other : axis.cross(Vec3::UnitY());
    hand *= 0.8 * size / hand.norm();
    const auto rim = [&](double angle) {
        return Vec3(at + engine::turnAbout(axis, angle - joint.position) * hand);
    };
    addLine(at, rim(joint.position), kArcPixels, render::normalColor(), frame);
    if (!limits.any()) return;
    const double turn = engine::radians(360.0);  // more is drawn as the whole round
    const double low = larger(limits.low, joint.position - turn);
    const double high = smaller(limits.high, joint.position + turn);
    constexpr int kSteps = 24;
    for (int i = 0; i < kSteps; ++i)
        addLine(rim(low + (high - low) * i / kSteps), rim(low + (high - low) * (i + 1) / kSteps),
                kArcPixels, render::frictionColor(), frame);
    for (const double limit : {limits.low, limits.high})
        if (std::isfinite(limit)) addLine(at, rim(limit), kAxisPixels, render::frictionColor(), frame);
}

void addGear(const Stage& stage, const JointState& joint, double size, render::Frame& frame) {
    const Vec3 a = stage.world.pose(joint.def.a).position;
    const Vec3 b = stage.world.pose(joint.def.b).position;
    addAxis(a, joint.worldAxis, size, frame);
    addAxis(b, joint.worldAxis2, size, frame);
    addLine(a, b, kAxisPixels, render::frictionColor(), frame);
}

}  // namespace

void addJointMarks(const Stage& stage, const JointState& joint, render::Frame& frame) {
    const JointType type = joint.def.type;
    const double size = sizeOf(stage, joint);
    if (type == JointType::gear) return addGear(stage, joint, size, frame);
    if (type != JointType::axis && type != JointType::path)
        addAnchor(stage, joint.def.a, joint.worldA, 4.5f, render::jointColor(), frame);
    addAnchor(stage, joint.def.b, joint.worldB, 3.0f, render::normalColor(), frame);
    const bool twoAxes = type == JointType::universal || type == JointType::wheel ||
                         type == JointType::constantVelocity;
    if (twoAxes || type == JointType::hinge || type == JointType::axis || type == JointType::slider)
        addAxis(type == JointType::hinge ? joint.worldA : joint.worldB, joint.worldAxis, size, frame);
    if (twoAxes) addAxis(joint.worldB, joint.worldAxis2, size, frame);
    if (type == JointType::hinge || type == JointType::axis) addAngle(stage, joint, size, frame);
    if (type == JointType::lookAt)
        addLine(joint.worldB, joint.worldA, kAxisPixels, render::normalColor(), frame);
}

}  // namespace demos
