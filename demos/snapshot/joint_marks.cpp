// --show joints: anchors and axes; coordinates and limits are in joint_fans.cpp.
#include "demos/snapshot/frame_parts.h"
#include "demos/snapshot/joint_fans.h"
#include "render/palette.h"

namespace demos {
namespace {

using engine::JointState;
using engine::JointType;
using engine::smaller;

/// m: the body's reach; 0 for the ground.
double extentOf(const Stage& stage, engine::BodyId body) {
    return body == stage.ground ? 0.0 : reachOf(stage.world.def(body).shape);
}

/// The ground and meshes have no reach: an anchor on them may be inside the other body.
void addAnchor(const Stage& stage, engine::BodyId body, engine::BodyId other, const Vec3& at,
               float pixels, const render::Color& color, render::Frame& frame) {
    render::Marker marker{drawn(at), pixels, color};
    const double own = extentOf(stage, body);
    marker.reach = static_cast<float>(2.0 * (own > 0.0 ? own : extentOf(stage, other)));
    frame.markers.push_back(marker);
}

/// m: the extent of the marks, by the smaller of the two bodies.
double sizeOf(const Stage& stage, const JointState& joint) {
    double size = 0.0;
    for (const engine::BodyId body : {joint.def.a, joint.def.b}) {
        const double reach = extentOf(stage, body);
        if (reach > 0.0) size = size > 0.0 ? smaller(size, reach) : reach;
    }
    return 1.2 * size;
}

void addAxis(const Vec3& at, const Vec3& axis, double size, render::Frame& frame) {
    addLine(at - size * axis, at + size * axis, kAxisPixels, render::jointColor(), frame);
}

/// The axes fixed in a; for joints with two axes, axis2 is the one fixed in b.
void addAxes(const JointState& joint, double size, render::Frame& frame) {
    const JointType type = joint.def.type;
    const bool two = type == JointType::universal || type == JointType::wheel ||
                     type == JointType::constantVelocity;
    const bool one =
        type == JointType::hinge || type == JointType::axis || type == JointType::slider;
    if (!one && !two) return;
    addAxis(type == JointType::hinge ? joint.worldA : joint.worldB, joint.worldAxis, size, frame);
    if (two) addAxis(joint.worldB, joint.worldAxis2, size, frame);
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
    const engine::BodyId a = joint.def.a, b = joint.def.b;
    if (type != JointType::axis && type != JointType::path)
        addAnchor(stage, a, b, joint.worldA, 4.5f, render::jointColor(), frame);
    addAnchor(stage, b, a, joint.worldB, 3.0f, render::normalColor(), frame);
    addAxes(joint, size, frame);
    switch (type) {
        case JointType::hinge:
        case JointType::axis:
            return addHingeAngle(stage, joint, size, frame);
        case JointType::ball:
        case JointType::constantVelocity:
            return addSwingAndTwist(stage, joint, size, frame);
        case JointType::universal:
            return addUniversalAngles(joint, size, frame);
        case JointType::sixDof:
            return addSixDof(joint, size, frame);
        case JointType::wheel:
            return addSuspension(joint, size, frame);
        case JointType::lookAt:
            return addLine(joint.worldB, joint.worldA, kAxisPixels, render::normalColor(), frame);
        default:
            return;
    }
}

}  // namespace demos
