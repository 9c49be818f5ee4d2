// Rods between joined bodies, and the anchors.
#include <algorithm>

#include "demos/snapshot/parts.h"
#include "render/palette.h"

namespace demos {
namespace {

constexpr float kRodRadius = 0.025f;  // m

/// Whether a point in body axes lies in the shape or on it.
bool covers(const engine::Shape& shape, const Vec3& local) {
    constexpr double kHair = 1e-6;  // m
    switch (shape.type) {
        case engine::ShapeType::sphere:
            return local.norm() <= shape.radius + kHair;
        case engine::ShapeType::box:
            return ((local.cwiseAbs() - shape.halfSize).array() <= kHair).all();
        case engine::ShapeType::capsule: {
            const double y = std::clamp(local.y(), -shape.halfLength, shape.halfLength);
            return (local - Vec3(0, y, 0)).norm() <= shape.radius + kHair;
        }
        case engine::ShapeType::plane:
            return true;
    }
    return true;
}

/// The arm from a body's centre to an anchor that its shape does not reach.
void addArm(const Stage& stage, engine::BodyId body, const Vec3& local, const Vec3& anchor,
            render::Frame& frame) {
    if (body == stage.ground || covers(stage.world.def(body).shape, local)) return;
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
