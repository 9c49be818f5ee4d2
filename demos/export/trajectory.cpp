#include "demos/export/trajectory.h"

#include "demos/export/bars.h"
#include "demos/snapshot/camera.h"
#include "demos/snapshot/colors.h"
#include "demos/theme.h"

namespace demos {
namespace {

/// A file has one colour a body: what changes with the run leaves bodies their own.
Overlays lasting(Overlays overlays) {
    for (const char* changing : {"speed", "impulse", "island"})
        if (overlays.colorBy == changing) overlays.colorBy = "body";
    return overlays;
}

}  // namespace

BodyMotion motionOf(const Stage& stage, std::size_t body) {
    const engine::BodyId id = stage.bodies[body];
    return {stage.world.pose(id), stage.world.velocity(id), stage.world.spin(id)};
}

void TrajectoryRecorder::look(const Player& player, long step) {
    if (step == 0) begin(player);
    if (step > 0) events_.look(player.stage());
    if (step % stepsPerFrame_ == 0) addFrame(player, step);
}

const Trajectory& TrajectoryRecorder::finished() {
    trajectory_.events = events_.events();
    return trajectory_;
}

void TrajectoryRecorder::begin(const Player& player) {
    const Stage& stage = player.stage();
    trajectory_.colors = bodyColors(stage, lasting(overlays_), player.history());
    for (std::size_t i = 0; i < stage.bodies.size(); ++i)
        if (stage.world.def(stage.bodies[i]).sensor) trajectory_.colors[i].a = kSensorAlpha;
    render::Frame frame;
    applyTheme(overlays_.theme, frame);
    trajectory_.look = frame.look;
}

void TrajectoryRecorder::addFrame(const Player& player, long step) {
    const Stage& stage = player.stage();
    TrajectoryFrame& frame = trajectory_.frames.emplace_back();
    frame.time = static_cast<double>(step) / stage.scene.hz;
    for (std::size_t i = 0; i < stage.bodies.size(); ++i)
        frame.bodies.push_back(motionOf(stage, i));
    frame.energy = stage.world.energy();
    if (step > 0)
        frame.contacts.assign(stage.world.contacts().begin(), stage.world.contacts().end());
    frame.camera = cameraOf({stage, overlays_, player.history(), frame.time});
    frame.bars = barsNow(stage, player.history(), frame.time);
}

}  // namespace demos
