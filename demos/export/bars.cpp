#include "demos/export/bars.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "demos/snapshot/coil.h"
#include "demos/snapshot/parts.h"

namespace demos {
namespace {

/// "hook bar 1"; springs that are forces come after the joints.
std::string nameOf(const Stage& stage, int id, int number) {
    const auto joint = static_cast<std::size_t>(id) - stage.bodies.size();
    const std::vector<JointDescription>& joints = stage.scene.joints;
    const std::string owner = joint < joints.size()
                                  ? joints[joint].name
                                  : fmt::format("spring {}", joint - joints.size());
    return fmt::format("{} bar {}", owner, number + 1);
}

bool isTrack(const Stage& stage, int id) {
    const auto joint = static_cast<std::size_t>(id) - stage.bodies.size();
    return joint < stage.joints.size() &&
           stage.world.joint(stage.joints[joint]).def.type == engine::JointType::path;
}

/// From the pose before by the least turn, so that the bar does not twist on its way.
engine::Pose poseOf(const render::Rod& rod, const engine::Pose& before) {
    const Vec3 way = (rod.to - rod.from).cast<double>();
    const Vec3 axis = before.rotation * Vec3::UnitY();
    return {0.5 * (rod.from + rod.to).cast<double>(),
            (Quat::FromTwoVectors(axis, way) * before.rotation).normalized()};
}

/// Where a bar is in a frame; before it is first seen it waits there, without a size.
void place(const render::Rod& rod, std::size_t frame, BarMotion& bar) {
    const float half = 0.5f * (rod.to - rod.from).norm();
    if (!(half > 0.0f)) return;
    const bool first = bar.poses.empty();
    const engine::Pose pose = poseOf(rod, first ? engine::Pose{} : bar.poses.back());
    bar.poses.resize(frame, first ? pose : bar.poses.back());
    bar.sizes.resize(frame, render::Vec3::Zero());
    bar.poses.push_back(pose);
    bar.sizes.emplace_back(rod.radius, half, rod.radius);
}

}  // namespace

std::vector<BarMotion> barsOf(const Stage& stage, const Trajectory& trajectory) {
    std::map<std::pair<int, int>, BarMotion> bars;  // by joint, and which of its bars
    for (std::size_t frame = 0; frame < trajectory.frames.size(); ++frame) {
        std::map<int, int> seen;  // bars of each joint so far
        for (const render::Rod& rod : trajectory.frames[frame].bars) {
            const int number = seen[rod.id]++;
            BarMotion& bar = bars[{rod.id, number}];
            if (bar.name.empty()) bar.name = nameOf(stage, rod.id, number);
            bar.color = rod.color;
            place(rod, frame, bar);
        }
    }
    std::vector<BarMotion> result;
    for (auto& [key, bar] : bars) {
        if (bar.poses.empty()) continue;  // never long enough to be seen
        bar.poses.resize(trajectory.frames.size(), engine::Pose(bar.poses.back()));
        bar.sizes.resize(trajectory.frames.size(), render::Vec3::Zero());
        result.push_back(std::move(bar));
    }
    return result;
}

std::vector<render::Rod> barsNow(const Stage& stage, const History& history, double time) {
    render::Frame frame;
    addJoints({stage, Overlays{}, history, time}, frame);
    const std::vector<render::Rod>& rods = frame.rods;
    std::vector<render::Rod> bars;
    for (std::size_t i = 0; i < rods.size(); ++i) {
        bars.push_back(rods[i]);
        const std::size_t last = i + kCoilRods - 1;
        if (last >= rods.size() || rods[last].id != rods[i].id || isTrack(stage, rods[i].id))
            continue;
        bars.back().to = rods[last].to;
        i = last;
    }
    return bars;
}

}  // namespace demos
