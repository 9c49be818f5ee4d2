#include "demos/export/recording.h"

#include <algorithm>

#include "demos/export/recorded_bars.h"
#include "demos/player.h"
#include "demos/snapshot/camera.h"
#include "demos/snapshot/colors.h"
#include "demos/snapshot/parts.h"
#include "demos/snapshot/scale.h"
#include "demos/stop.h"

namespace demos {
namespace {

constexpr float kSensorAlpha = 0.34f;  // as drawn

/// A body has one colour here: what changes with the run leaves bodies their own.
Overlays lasting(Overlays overlays) {
    for (const char* changing : {"speed", "impulse", "island"})
        if (overlays.colorBy == changing) overlays.colorBy = "body";
    return overlays;
}

void addBodies(const Player& player, Recording& recording) {
    const Stage& stage = player.stage();
    const std::vector<render::Color> colors =
        bodyColors(stage, lasting(recording.overlays), player.history());
    for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
        const engine::BodyDef& def = stage.world.def(stage.bodies[i]);
        RecordedBody& body = recording.bodies.emplace_back();
        body = {stage.scene.bodies[i].name, colors[i], stage.drawn[i],
                stage.world.mass(stage.bodies[i])};
        if (def.sensor) body.color.a = kSensorAlpha;
        const double thickness = thicknessOf(def.shape);
        const bool thinner = recording.thinnest == 0.0 || thickness < recording.thinnest;
        if (body.mass > 0.0 && thickness > 0.0 && thinner) recording.thinnest = thickness;
    }
}

void addTrails(const Stage& stage, Recording& recording) {
    for (const std::string& name : stage.scene.look.trails)
        for (std::size_t i = 0; i < stage.scene.bodies.size(); ++i)
            if (stage.scene.bodies[i].name == name) recording.trails.push_back(static_cast<int>(i));
}

RecordedFrame frameOf(const Player& player, const Overlays& overlays, double time, bool stepped) {
    const Stage& stage = player.stage();
    RecordedFrame frame;
    for (const engine::BodyId body : stage.bodies) {
        frame.poses.push_back(stage.world.pose(body));
        frame.speeds.push_back(stage.world.velocity(body).norm());
    }
    if (stepped)
        for (const engine::ContactState& contact : stage.world.contacts())
            if (contact.impulse > 0.0)
                frame.contacts.push_back(
                    {contact.position, contact.normal, contact.impulse, contact.friction});
    frame.measures = measuresOf(stage);
    frame.camera = cameraOf({stage, overlays, player.history(), time});
    frame.shot = shotAt(stage.scene.camera, time);
    frame.impulsePeak = player.history().impulsePeak;
    return frame;
}

/// Counts the frames for which joints are there.
void countJoints(const Stage& stage, std::vector<RecordedJoint>& joints) {
    for (std::size_t i = 0; i < joints.size(); ++i)
        if (!stage.world.joint(stage.joints[i]).removed) ++joints[i].frames;
}

Recording begun(const FilmPlan& plan, const Player& player) {
    const Stage& stage = player.stage();
    Recording recording;
    recording.name = plan.name;
    recording.title = stage.scene.title;
    recording.framesASecond = plan.fps;
    recording.seconds = plan.timeOf(plan.frames);
    recording.viewHeight = viewHeight(stage.scene.camera);
    recording.overlays = plan.panels.front().overlays;
    recording.sections = stage.scene.sections;
    recording.grounds = player.frame(0.0).grounds;
    recording.joints = jointsOf(stage);
    addBodies(player, recording);
    addTrails(stage, recording);
    return recording;
}

}  // namespace

namespace {

/// A run that diverges is worth a look all the more: what was good stays.
bool goneOn(int steps, Player& player, Recording& recording) try {
    player.step(steps);
    return true;
} catch (const Stop& stop) {
    recording.trouble = stop.what();
    return false;
}

}  // namespace

Recording recordingOf(const FilmPlan& plan) {
    const Overlays& overlays = plan.panels.front().overlays;
    Player player(plan.scene(), overlays);
    Recording recording = begun(plan, player);
    std::vector<SlideRange> slides;
    for (int frame = 0; frame <= plan.frames; ++frame) {
        if (frame > 0 && !goneOn(plan.stepsPerFrame, player, recording)) break;
        recording.frames.push_back(frameOf(player, overlays, plan.timeOf(frame), frame > 0));
        countJoints(player.stage(), recording.joints);
        widen(player.stage(), slides);
    }
    recording.bars = barsOf(Stage(plan.scene()), slides);  // before anything broke
    return recording;
}

}  // namespace demos
