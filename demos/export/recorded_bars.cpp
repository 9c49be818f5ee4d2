#include "demos/export/recorded_bars.h"

#include <algorithm>
#include <cmath>

#include "engine/constraints/catmull_rom.h"
#include "engine/shapes/inside.h"

namespace demos {
namespace {

using engine::JointType;

constexpr double kRodRadius = 0.025;   // m
constexpr double kRailRadius = 0.012;  // m

engine::Pose poseOf(const Stage& stage, engine::BodyId body) { return stage.world.pose(body); }

bool isSprung(const engine::JointDef& def) {
    return def.spring.isSoft() || def.free[0].spring.isSoft();
}

/// Joints that hold their anchors together, but for their arms.
bool meetsA(JointType type) {
    return type <= JointType::weld || type == JointType::universal ||
           type == JointType::constantVelocity;
}

/// Bars of one joint.
class JointBars {
public:
    JointBars(const Stage& stage, int joint, const SlideRange& range)
        : stage_(stage), joint_(joint), range_(range) {}

    std::vector<RecordedBar> all() {
        const engine::JointState state = stage_.world.joint(stage_.joints[joint_]);
        const engine::JointDef& def = state.def;
        if (state.removed) return {};
        if (def.type == JointType::distance) addDistance(def);
        if (def.type == JointType::slider) addRail(state);
        if (def.type == JointType::path) addTrack(def);
        if (meetsA(def.type)) addArm(def.a, def.anchorA);
        if (meetsA(def.type) || def.type == JointType::path || def.type == JointType::slider)
            addArm(def.b, def.anchorB);
        return std::move(bars_);
    }

private:
    void add(engine::BodyId a, const Vec3& atA, engine::BodyId b, const Vec3& atB, double radius) {
        bars_.push_back(
            {recordedPlace(stage_, a), recordedPlace(stage_, b), atA, atB, radius, -1.0, joint_});
    }

    void addDistance(const engine::JointDef& def) {
        add(def.a, def.anchorA, def.b, def.anchorB, kRodRadius);
        if (isSprung(def)) bars_.back().rest = def.length;
    }

    /// As far as it can slide, and where nothing stops it as far as it does.
    void addRail(const engine::JointState& joint) {
        const engine::Limits& limits = joint.def.free[0].limits;
        const double size = engine::reachOf(stage_.world.def(joint.def.b).shape);
        const engine::Pose a = poseOf(stage_, joint.def.a);
        const auto end = [&](double limit, double beyond) {
            const double way = std::isfinite(limit) ? limit : beyond;
            return a.toLocal(joint.worldA + way * joint.worldAxis);
        };
        add(joint.def.a, end(limits.low, range_.low - size), joint.def.a,
            end(limits.high, range_.high + size), kRailRadius);
    }

    void addTrack(const engine::JointDef& def) {
        constexpr int kSteps = 12;  // a piece
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
    const SlideRange& range_;
    std::vector<RecordedBar> bars_;
};

void addSprings(const Stage& stage, std::vector<RecordedBar>& bars) {
    for (const ForceDescription& force : stage.scene.forces)
        if (const auto* spring = std::get_if<engine::SpringForce>(&force.def.kind))
            bars.push_back({force.def.on[0].index, force.def.on[1].index, spring->anchorA,
                            spring->anchorB, 0.0, spring->length, -1});
}

}  // namespace

int recordedPlace(const Stage& stage, engine::BodyId body) {
    return body == stage.ground ? -1 : body.index;
}

void widen(const Stage& stage, std::vector<SlideRange>& ranges) {
    ranges.resize(stage.joints.size());
    for (std::size_t i = 0; i < stage.joints.size(); ++i) {
        const engine::JointState joint = stage.world.joint(stage.joints[i]);
        if (joint.removed || joint.def.type != JointType::slider) continue;
        ranges[i].low = std::min(ranges[i].low, joint.position);
        ranges[i].high = std::max(ranges[i].high, joint.position);
    }
}

std::vector<RecordedBar> barsOf(const Stage& stage, const std::vector<SlideRange>& ranges) {
    std::vector<RecordedBar> bars;
    for (std::size_t i = 0; i < stage.joints.size(); ++i)
        for (const RecordedBar& bar : JointBars(stage, static_cast<int>(i), ranges[i]).all())
            bars.push_back(bar);
    addSprings(stage, bars);
    return bars;
}

std::vector<RecordedJoint> jointsOf(const Stage& stage) {
    std::vector<RecordedJoint> joints;
    for (std::size_t i = 0; i < stage.joints.size(); ++i) {
        const engine::JointDef def = stage.world.joint(stage.joints[i]).def;
        joints.push_back({stage.scene.joints[i].name, recordedPlace(stage, def.a),
                          recordedPlace(stage, def.b), def.anchorA, def.anchorB, 0});
    }
    return joints;
}

}  // namespace demos
