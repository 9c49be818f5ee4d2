// What a joint is made of: rods, springs, rails, tracks, and arms to bodies that do not reach it.
#include "demos/snapshot/coil.h"
#include "demos/snapshot/parts.h"
#include "engine/constraints/catmull_rom.h"
#include "engine/shapes/inside.h"
#include "render/palette.h"

namespace demos {
namespace {

using engine::JointType;
using engine::larger;
using engine::smaller;

constexpr float kRodRadius = 0.025f;   // m
constexpr float kRailRadius = 0.012f;  // m

void addRod(const Vec3& from, const Vec3& to, float radius, render::Frame& frame) {
    frame.rods.push_back({drawn(from), drawn(to), radius, render::jointColor()});
}

/// The arm from a body's centre to an anchor that its shape does not reach.
void addArm(const Stage& stage, engine::BodyId body, const Vec3& local, const Vec3& anchor,
            render::Frame& frame) {
    constexpr double kHair = 1e-6;  // m
    if (local.isZero(kHair)) return;
    if (body == stage.ground || engine::isInside(stage.world.def(body).shape, local, kHair)) return;
    addRod(stage.world.pose(body).position, anchor, kRodRadius, frame);
}

bool isSprung(const engine::JointDef& def) {
    return def.spring.isSoft() || def.free[0].spring.isSoft();
}

/// As far as it can slide; twice the body's size where nothing stops it.
void addRail(const Stage& stage, const engine::JointState& joint, render::Frame& frame) {
    const engine::Limits& limits = joint.def.free[0].limits;
    const double size = reachOf(stage.world.def(joint.def.b).shape);
    const auto end = [&](double limit, double beyond) {
        return joint.worldA + (std::isfinite(limit) ? limit : beyond) * joint.worldAxis;
    };
    addRod(end(limits.low, smaller(joint.position, 0.0) - size),
           end(limits.high, larger(joint.position, 0.0) + size), kRailRadius, frame);
}

void addTrack(const Stage& stage, const engine::JointState& joint, render::Frame& frame) {
    constexpr int kSteps = 12;  // a piece
    const engine::JointDef& def = joint.def;
    const engine::Pose a = stage.world.pose(def.a);
    const auto at = [&](int i) {
        const double t = static_cast<double>(i) / kSteps;
        return a.toWorld(engine::curveAt(def.path, def.closed, t).at);
    };
    for (int i = 0; i < kSteps * engine::pieces(def.path, def.closed); ++i)
        addRod(at(i), at(i + 1), kRailRadius, frame);
}

void addParts(const Stage& stage, const engine::JointState& joint, render::Frame& frame) {
    const engine::JointDef& def = joint.def;
    if (def.type == JointType::distance && isSprung(def))
        addCoil(drawn(joint.worldA), drawn(joint.worldB), static_cast<float>(def.length), 0, frame);
    else if (def.type == JointType::distance)
        addRod(joint.worldA, joint.worldB, kRodRadius, frame);
    if (def.type == JointType::slider) addRail(stage, joint, frame);
    if (def.type == JointType::path) addTrack(stage, joint, frame);
    // A slider or a path goes past its anchor on a; a gear, an axis and a look-at hold no places.
    const bool meetsA = def.type <= JointType::weld || def.type == JointType::universal ||
                        def.type == JointType::constantVelocity;
    if (meetsA) addArm(stage, def.a, def.anchorA, joint.worldA, frame);
    if (meetsA || def.type == JointType::path || def.type == JointType::slider)
        addArm(stage, def.b, def.anchorB, joint.worldB, frame);
}

void addSpringForces(const Stage& stage, render::Frame& frame) {
    const auto world = [&](engine::BodyId body, const Vec3& anchor) {
        return body.index < 0 ? anchor : stage.world.pose(stage.bodies[body.index]).toWorld(anchor);
    };
    const auto springs = static_cast<int>(stage.bodies.size() + stage.joints.size());
    for (int i = 0; i < static_cast<int>(stage.scene.forces.size()); ++i) {
        const engine::ForceDef& def = stage.scene.forces[i].def;
        if (const auto* spring = std::get_if<engine::SpringForce>(&def.kind))
            addCoil(drawn(world(def.on[0], spring->anchorA)),
                    drawn(world(def.on[1], spring->anchorB)), static_cast<float>(spring->length),
                    springs + i, frame);
    }
}

}  // namespace

void addJoints(const Moment& moment, render::Frame& frame) {
    const Stage& stage = moment.stage;
    for (const engine::JointId id : stage.joints) {
        const engine::JointState joint = stage.world.joint(id);
        if (joint.removed) continue;
        const std::size_t first = frame.rods.size();
        addParts(stage, joint, frame);
        for (std::size_t i = first; i < frame.rods.size(); ++i)  // numbered after the bodies
            frame.rods[i].id = static_cast<int>(stage.bodies.size()) + id.index;
        if (moment.overlays.joints) addJointMarks(stage, joint, frame);
    }
    addSpringForces(stage, frame);
}

}  // namespace demos
