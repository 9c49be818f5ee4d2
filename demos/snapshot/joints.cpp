// Joints and springs: their bars as rods and coils, and the marks of --show joints.
#include "demos/snapshot/coil.h"
#include "demos/snapshot/frame_parts.h"
#include "demos/snapshot/joint_bars.h"
#include "render/palette.h"

namespace demos {
namespace {

void addBar(const Stage& stage, const JointBar& bar, render::Frame& frame) {
    const render::Vec3 from = drawn(poseAt(stage, bar.a).toWorld(bar.atA));
    const render::Vec3 to = drawn(poseAt(stage, bar.b).toWorld(bar.atB));
    const int id = static_cast<int>(stage.bodies.size()) + bar.joint;  // numbered after the bodies
    if (bar.rest >= 0.0)
        addCoil(from, to, static_cast<float>(bar.rest), id, frame);
    else
        frame.rods.push_back(
            {from, to, static_cast<float>(bar.radius), render::jointColor(), id});
}

}  // namespace

void addJoints(const Moment& moment, render::Frame& frame) {
    const Stage& stage = moment.stage;
    for (const JointBar& bar : barsNow(stage)) addBar(stage, bar, frame);
    if (!moment.overlays.joints) return;
    for (const engine::JointId id : stage.joints)
        if (const engine::JointState joint = stage.world.joint(id); !joint.removed)
            addJointMarks(stage, joint, frame);
}

}  // namespace demos
