// Rods between joined bodies, and the anchors.
#include "demos/snapshot/parts.h"
#include "engine/shapes/inside.h"
#include "render/palette.h"

namespace demos {
namespace {

constexpr float kRodRadius = 0.025f;  // m

/// The arm from a body's centre to an anchor that its shape does not reach.
void addArm(const Stage& stage, engine::BodyId body, const Vec3& local, const Vec3& anchor,
            render::Frame& frame) {
    constexpr double kHair = 1e-6;  // m
    if (local.isZero(kHair)) return;
    if (body == stage.ground || engine::isInside(stage.world.def(body).shape, local, kHair)) return;
    frame.rods.push_back(
        {drawn(stage.world.pose(body).position), drawn(anchor), kRodRadius, render::jointColor()});
}

void addAnchor(const Stage& stage, engine::BodyId body, const Vec3& at, float pixels,
               const render::Color& color, render::Frame& frame) {
    render::Marker marker{drawn(at), pixels, color};
    if (body != stage.ground)
        marker.reach = static_cast<float>(2.0 * reachOf(stage.world.def(body).shape));
    frame.markers.push_back(marker);
}

}  // namespace

void addJoints(const Moment& moment, render::Frame& frame) {
    const Stage& stage = moment.stage;
    for (const engine::JointId id : stage.joints) {
        const engine::JointState joint = stage.world.joint(id);
        if (joint.removed) continue;
        const std::size_t first = frame.rods.size();
        if (joint.def.type == engine::JointType::distance)
            frame.rods.push_back(
                {drawn(joint.worldA), drawn(joint.worldB), kRodRadius, render::jointColor()});
        addArm(stage, joint.def.a, joint.def.anchorA, joint.worldA, frame);
        addArm(stage, joint.def.b, joint.def.anchorB, joint.worldB, frame);
        for (std::size_t i = first; i < frame.rods.size(); ++i)  // numbered after the bodies
            frame.rods[i].id = static_cast<int>(stage.bodies.size()) + id.index;
        if (!moment.overlays.joints) continue;
        addAnchor(stage, joint.def.a, joint.worldA, 4.5f, render::jointColor(), frame);
        addAnchor(stage, joint.def.b, joint.worldB, 3.0f, render::normalColor(), frame);
    }
}

}  // namespace demos
