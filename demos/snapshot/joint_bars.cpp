// The bars of a joint: rods, springs, rails, tracks, and arms to bodies that do not reach it.
#include "demos/snapshot/joint_bars.h"

#include <algorithm>
#include <cmath>

#include "engine/constraints/catmull_rom.h"
#include "engine/shapes/inside.h"

namespace demos {
namespace {

using engine::JointType;

constexpr double kRodRadius = 0.025;   // m
constexpr double kRailRadius = 0.012;  // m

bool isSprung(const engine::JointDef& def) {
    return def.spring.isSoft() || def.free[0].spring.isSoft();
}

/// Joints that hold their anchors together, which only need arms. A slider or a path moves past its
/// anchor on a; a gear, an axis and a look-at do not hold positions.
bool meetsA(JointType type) {
    return type <= JointType::weld || type == JointType::universal ||
           type == JointType::constantVelocity;
}

/// Adds the bars of one joint.
class JointBars {
public:
    JointBars(const Stage& stage, int joint, const engine::JointState& state,
              std::vector<JointBar>& bars)
        : stage_(stage), joint_(joint), state_(state), bars_(bars) {}

    /// `range`: the range of a slider.
    void addAll(const SlideRange& range) {
        const engine::JointDef& def = state_.def;
        if (def.type == JointType::distance) addDistance(def);
        if (def.type == JointType::slider) addRail(def, range);
        if (def.type == JointType::path) addTrack(def);
        if (meetsA(def.type)) addArm(def.a, def.anchorA);
        if (meetsA(def.type) || def.type == JointType::path || def.type == JointType::slider)
            addArm(def.b, def.anchorB);
    }

private:
    void add(engine::BodyId a, const Vec3& atA, engine::BodyId b, const Vec3& atB, double radius) {
        bars_.push_back({bodyPlace(stage_, a), bodyPlace(stage_, b), atA, atB, radius, -1.0, joint_});
    }

    void addDistance(const engine::JointDef& def) {
        add(def.a, def.anchorA, def.b, def.anchorB, kRodRadius);
        if (isSprung(def)) bars_.back().rest = def.length;
    }

    /// As long as it can slide; without a limit, by the body's size beyond `range`.
    void addRail(const engine::JointDef& def, const SlideRange& range) {
        const engine::Limits& limits = def.free[0].limits;
        const double size = engine::reachOf(stage_.world.def(def.b).shape);
        const engine::Pose a = stage_.world.pose(def.a);
        const auto end = [&](double limit, double beyond) {
            const double way = std::isfinite(limit) ? limit : beyond;
            return a.toLocal(state_.worldA + way * state_.worldAxis);
        };
        add(def.a, end(limits.low, range.low - size), def.a, end(limits.high, range.high + size),
            kRailRadius);
    }

    void addTrack(const engine::JointDef& def) {
        constexpr int kSteps = 12;  // per piece
        const auto at = [&](int i) {
            return engine::curveAt(def.path, def.closed, static_cast<double>(i) / kSteps).at;
        };
        for (int i = 0; i < kSteps * engine::pieces(def.path, def.closed); ++i)
            add(def.a, at(i), def.a, at(i + 1), kRailRadius);
    }

    /// From a body's centre to an anchor that its shape does not reach.
    void addArm(engine::BodyId body, const Vec3& anchor) {
        constexpr double kHair = 1e-6;  // m
        if (body == stage_.ground || anchor.isZero(kHair)) return;
        if (engine::isInside(stage_.world.def(body).shape, anchor, kHair)) return;
        add(body, Vec3::Zero(), body, anchor, kRodRadius);
    }

    const Stage& stage_;
    int joint_;
    const engine::JointState& state_;
    std::vector<JointBar>& bars_;
};

void addSprings(const Stage& stage, std::vector<JointBar>& bars) {
    int number = static_cast<int>(stage.joints.size());
    for (const ForceDescription& force : stage.scene.forces) {
        if (const auto* spring = std::get_if<engine::SpringForce>(&force.def.kind))
            bars.push_back({force.def.on[0].index, force.def.on[1].index, spring->anchorA,
                            spring->anchorB, 0.0, spring->length, number});
        ++number;
    }
}

}  // namespace

void SlideRange::widen(double position) {
    low = std::min(low, position);
    high = std::max(high, position);
}

std::vector<JointBar> barsNow(const Stage& stage) {
    std::vector<JointBar> bars;
    for (int i = 0; i < static_cast<int>(stage.joints.size()); ++i) {
        const engine::JointState joint = stage.world.joint(stage.joints[i]);
        if (joint.removed) continue;
        SlideRange here;
        here.widen(joint.position);
        JointBars(stage, i, joint, bars).addAll(here);
    }
    addSprings(stage, bars);
    return bars;
}

std::vector<JointBar> barsOfRun(const Stage& stage, const std::vector<SlideRange>& slides) {
    std::vector<JointBar> bars;
    for (std::size_t i = 0; i < stage.joints.size(); ++i)
        JointBars(stage, static_cast<int>(i), stage.world.joint(stage.joints[i]), bars)
            .addAll(slides[i]);
    addSprings(stage, bars);
    return bars;
}

int bodyPlace(const Stage& stage, engine::BodyId body) {
    return body == stage.ground ? -1 : body.index;
}

engine::Pose poseAt(const Stage& stage, int place) {
    return stage.world.pose(place < 0 ? stage.ground : stage.bodies[place]);
}

}  // namespace demos
