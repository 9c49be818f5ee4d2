#include "demos/regression/trajectory_recorder.h"

#include <algorithm>

#include "demos/measures/measures.h"
#include "engine/shapes/bounds.h"

namespace demos {
namespace {

constexpr std::size_t kMostPoses = 200'000;  // of all bodies while the trajectory is dense: 11 MB

/// Half the sides of the body's bounding box, in its own axes; 0 for an infinite shape.
Vec3 extentOf(const engine::Shape& shape) {
    if (shape.type == engine::ShapeType::plane) return Vec3::Zero();
    const engine::Bounds bounds = engine::boundsOf(shape, {});
    return bounds.low.cwiseAbs().cwiseMax(bounds.high.cwiseAbs());
}

}  // namespace

TrajectoryRecorder::TrajectoryRecorder(const Stage& stage, int steps) : steps_(steps) {
    trajectory_.hz = stage.scene.hz;
    trajectory_.dense = std::max(static_cast<int>(kMostPoses / (stage.bodies.size() + 1)), 1);
    if (trajectory_.dense >= steps) trajectory_.dense = Trajectory::kAll;
    trajectory_.gravity = stage.scene.gravity.norm();
    for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
        numbers_.emplace(stage.bodies[i], static_cast<int>(i));
        trajectory_.masses.push_back(stage.world.mass(stage.bodies[i]));
        trajectory_.bodies.push_back(stage.scene.bodies[i].name);
        trajectory_.extents.push_back(extentOf(stage.world.def(stage.bodies[i]).shape));
    }
}

void TrajectoryRecorder::look(const Stage& stage) {
    const std::uint64_t hash = stage.world.hash();
    trajectory_.hashes.push_back(static_cast<std::uint32_t>(hash ^ hash >> 32));
    if (step_ > 0) {  // before, nothing has been solved
        addContacts(stage);
        addJoints(stage);
    }
    if (hasMoment(step_, trajectory_.dense) || step_ == steps_)
        trajectory_.moments.push_back(momentOf(stage));
    ++step_;
}

TrajectoryMoment TrajectoryRecorder::momentOf(const Stage& stage) {
    TrajectoryMoment moment;
    moment.step = step_;
    for (const engine::BodyId body : stage.bodies) moment.poses.push_back(stage.world.pose(body));
    const Measures measures = measuresOf(stage);
    moment.energy = measures.energy.total();
    moment.penetration = measures.penetration;
    moment.separation = measures.separation;
    for (const auto& [constraint, value] : sums_) moment.impulses.push_back({constraint, value});
    sums_.clear();
    return moment;
}

/// Adds up the points of a pair: which of its corners carries the load does not matter here.
void TrajectoryRecorder::addContacts(const Stage& stage) {
    const auto numberOf = [this](engine::BodyId id) {
        const auto found = numbers_.find(id);
        return found == numbers_.end() ? -1 : found->second;
    };
    for (const engine::ContactState& contact : stage.world.contacts())
        if (contact.impulse != 0.0)
            sums_[constraintCalled(
                std::string(kContactPrefix) + stage.nameOf(contact.a) + "-" + stage.nameOf(contact.b),
                numberOf(contact.a), numberOf(contact.b))] += contact.impulse;
}

void TrajectoryRecorder::addJoints(const Stage& stage) {
    for (std::size_t i = 0; i < stage.joints.size(); ++i) {
        const engine::JointState state = stage.world.joint(stage.joints[i]);
        const JointDescription& joint = stage.scene.joints[i];
        const auto add = [&](std::string_view prefix, const Vec3& mean) {
            const double value = mean.norm() * stage.dt();
            if (value != 0.0)
                sums_[constraintCalled(std::string(prefix) + joint.name, joint.def.a.index,
                                       joint.def.b.index)] += value;
        };
        add(kJointPrefix, state.force);
        add(kTorquePrefix, state.torque);
    }
}

int TrajectoryRecorder::constraintCalled(const std::string& name, int a, int b) {
    const auto [found, added] =
        constraints_.emplace(name, static_cast<int>(trajectory_.constraints.size()));
    if (!added) return found->second;
    trajectory_.constraints.push_back(name);
    trajectory_.ends.push_back({a, b});
    return found->second;
}

}  // namespace demos
