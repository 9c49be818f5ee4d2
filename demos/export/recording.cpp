#include "demos/export/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/look/theme.h"
#include "demos/snapshot/camera.h"
#include "demos/snapshot/colors.h"
#include "demos/snapshot/frame_parts.h"
#include "demos/snapshot/scale.h"
#include "demos/text/stop.h"
#include "render/material.h"

namespace demos {
namespace {

constexpr double kMostPoses = 1e7;  // all bodies in all frames; a gigabyte of memory

/// A file has one colour per body: where colours would change in the run, bodies have their own.
Overlays lasting(Overlays overlays) {
    for (const char* changing : {"speed", "impulse", "island"})
        if (overlays.colorBy == changing) overlays.colorBy = "body";
    return overlays;
}

render::Look lookOf(const std::string& theme) {
    render::Frame frame;
    applyTheme(theme, frame);
    return frame.look;
}

std::vector<int> trailsOf(const SceneDescription& scene) {
    std::vector<int> trails;
    for (const std::string& name : scene.look.trails)
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            if (scene.bodies[i].name == name) trails.push_back(static_cast<int>(i));
    return trails;
}

std::vector<RecordedJoint> jointsOf(const Stage& stage) {
    std::vector<RecordedJoint> joints;
    for (std::size_t i = 0; i < stage.joints.size(); ++i) {
        const engine::JointDef def = stage.world.joint(stage.joints[i]).def;
        joints.push_back({stage.scene.joints[i].name, bodyPlace(stage, def.a),
                          bodyPlace(stage, def.b), def.anchorA, def.anchorB, 0});
    }
    return joints;
}

}  // namespace

BodyMotion motionOf(const Stage& stage, std::size_t body) {
    const engine::BodyId id = stage.bodies[body];
    return {stage.world.pose(id), stage.world.velocity(id), stage.world.spin(id)};
}

void checkLength(const FilmPlan& plan, const std::string& instead) {
    const std::size_t bodies = plan.scene().bodies.size();
    if (static_cast<double>(bodies) * plan.frames <= kMostPoses) return;
    throw Stop(Exit::usage,
               fmt::format("{} bodies in {} frames; an export holds at most {:.0f} million poses: "
                           "lower --fps or --seconds{}",
                           bodies, plan.frames, kMostPoses / 1e6,
                           instead.empty() ? "" : ", or use " + instead));
}

RunRecorder::RunRecorder(const FilmPlan& plan) : stepsPerFrame_(plan.stepsPerFrame) {
    recording_.name = plan.name;
    recording_.framesASecond = plan.fps;
    recording_.seconds = plan.timeOf(plan.frames);
    recording_.aspect = static_cast<double>(plan.layout.width) / plan.layout.height;
    recording_.overlays = plan.panels.front().overlays;
}

void RunRecorder::look(const Player& player, long step) {
    if (step == 0) begin(player);
    if (step > 0) events_.look(player.stage());
    if (step % stepsPerFrame_ == 0) addFrame(player, step);
}

const Recording& RunRecorder::finished(const Stage& stage) {
    recording_.bars = barsOfRun(stage, slides_);
    recording_.events = events_.events();
    return recording_;
}

void RunRecorder::begin(const Player& player) {
    const Stage& stage = player.stage();
    recording_.title = stage.scene.title;
    recording_.viewHeight = viewHeight(stage.scene.camera);
    recording_.sections = stage.scene.sections;
    recording_.grounds = player.frame(0.0).grounds;
    recording_.look = lookOf(recording_.overlays.theme);
    recording_.look.sunDirection = lightOf(stage.scene);
    recording_.joints = jointsOf(stage);
    recording_.trails = trailsOf(stage.scene);
    slides_.resize(stage.joints.size());
    addBodies(player);
}

void RunRecorder::addBodies(const Player& player) {
    const Stage& stage = player.stage();
    const std::vector<render::Color> colors =
        bodyColors(stage, lasting(recording_.overlays), player.history());
    double& thinnest = recording_.thinnest;
    for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
        const engine::BodyDef& def = stage.world.def(stage.bodies[i]);
        const double mass = stage.world.mass(stage.bodies[i]), thickness = thicknessOf(def.shape);
        RecordedBody& body = recording_.bodies.emplace_back();
        body = {stage.scene.bodies[i].name,
                colors[i],
                stage.scene.bodies[i].look,
                stage.drawn[i],
                Vec3::Zero(),
                mass};
        body.color.a = def.sensor ? kSensorAlpha : render::valuesOf(body.look).alpha;
        if (def.shape.type == engine::ShapeType::plane) body.plane = def.shape.normal;
        const bool thinner = thinnest == 0.0 || thickness < thinnest;
        if (mass > 0.0 && thickness > 0.0 && thinner) thinnest = thickness;
    }
}

void RunRecorder::addFrame(const Player& player, long step) {
    const Stage& stage = player.stage();
    RecordedFrame& frame = recording_.frames.emplace_back();
    frame.time = static_cast<double>(step) / stage.scene.hz;
    for (std::size_t i = 0; i < stage.bodies.size(); ++i)
        frame.bodies.push_back(motionOf(stage, i));
    if (step > 0) frame.contacts = stage.world.contacts();
    frame.bars = barsNow(stage);
    frame.measures = measuresOf(stage);
    frame.camera = cameraOf({stage, recording_.overlays, player.history(), frame.time});
    frame.shot = shotAt(stage.scene.camera, frame.time);
    frame.impulsePeak = player.history().impulsePeak;
    for (std::size_t i = 0; i < stage.joints.size(); ++i) {
        const engine::JointState joint = stage.world.joint(stage.joints[i]);
        if (joint.removed) continue;
        ++recording_.joints[i].frames;
        slides_[i].widen(joint.position);
    }
}

Recording recordingOf(const FilmPlan& plan) {
    Player player(plan.scene(), plan.panels.front().overlays);
    RunRecorder recorder(plan);
    const long steps = std::max(std::lround(plan.scene().seconds * plan.scene().hz), 1L);
    recorder.look(player, 0);
    for (long step = 1; step <= steps; ++step) {
        player.step();
        recorder.look(player, step);
    }
    return recorder.finished(player.stage());
}

}  // namespace demos
