#include "demos/export/bars.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "demos/snapshot/coil.h"
#include "demos/snapshot/frame_parts.h"
#include "render/shortest_turn.h"

namespace demos {
namespace {

/// "hook bar 1"; springs that are forces come after the joints.
std::string nameOf(const Recording& recording, int joint, int number) {
    const auto at = static_cast<std::size_t>(joint);
    const std::vector<RecordedJoint>& joints = recording.joints;
    const std::string owner =
        at < joints.size() ? joints[at].name : fmt::format("spring {}", at - joints.size());
    return fmt::format("{} bar {}", owner, number + 1);
}

/// A bar's end in a frame.
render::Vec3 endOf(const RecordedFrame& frame, int body, const Vec3& local) {
    return drawn(body < 0 ? local : frame.bodies[body].pose.toWorld(local));
}

float radiusOf(const JointBar& bar) {
    return bar.rest < 0.0 ? static_cast<float>(bar.radius)
                          : coilWire(static_cast<float>(bar.rest));
}

/// The pose before, turned as little as possible, so that the bar does not twist over time.
engine::Pose poseOf(const render::Vec3& from, const render::Vec3& to, const engine::Pose& before) {
    const Vec3 way = (to - from).cast<double>();
    const Vec3 axis = before.rotation * Vec3::UnitY();
    return {0.5 * (from + to).cast<double>(),
            (render::shortestTurn<double>(axis, way) * before.rotation).normalized()};
}

/// A bar's pose in a frame; before the bar is first seen it is there with size 0.
void place(const JointBar& bar, const Recording& recording, std::size_t number, BarMotion& motion) {
    const RecordedFrame& frame = recording.frames[number];
    const render::Vec3 from = endOf(frame, bar.a, bar.atA), to = endOf(frame, bar.b, bar.atB);
    const float half = 0.5f * (to - from).norm();
    if (!(half > 0.0f)) return;
    const bool first = motion.poses.empty();
    const engine::Pose pose = poseOf(from, to, first ? engine::Pose{} : motion.poses.back());
    motion.poses.resize(number, first ? pose : motion.poses.back());
    motion.sizes.resize(number, render::Vec3::Zero());
    motion.poses.push_back(pose);
    motion.sizes.emplace_back(radiusOf(bar), half, radiusOf(bar));
}

}  // namespace

std::vector<BarMotion> barsOf(const Recording& recording) {
    const std::size_t frames = recording.frames.size();
    std::map<std::pair<int, int>, BarMotion> motions;  // by joint, and which of its bars
    for (std::size_t frame = 0; frame < frames; ++frame) {
        std::map<int, int> seen;  // bars of each joint so far
        for (const JointBar& bar : recording.frames[frame].bars)
            place(bar, recording, frame, motions[{bar.joint, seen[bar.joint]++}]);
    }
    std::vector<BarMotion> result;
    for (auto& [key, motion] : motions) {
        if (motion.poses.empty()) continue;  // never long enough to be seen
        motion.name = nameOf(recording, key.first, key.second);
        motion.poses.resize(frames, engine::Pose(motion.poses.back()));
        motion.sizes.resize(frames, render::Vec3::Zero());
        result.push_back(std::move(motion));
    }
    return result;
}

}  // namespace demos
