#include "demos/snapshot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "demos/theme.h"
#include "render/palette.h"

namespace demos {
namespace {

render::Vec3 drawn(const Vec3& v) { return v.cast<float>(); }

render::Color colorOf(const Stage& stage, int i) {
    const BodyDescription& body = stage.scene.bodies[i];
    if (body.color) return render::fromHex(*body.color);
    if (body.def.kind == engine::BodyKind::fixed) return render::fixedColor();
    return render::paletteColor(i);
}

void addBody(const Stage& stage, int i, render::Frame& frame) {
    const engine::Shape& shape = stage.world.def(stage.bodies[i]).shape;
    const engine::Pose& pose = stage.world.pose(stage.bodies[i]);
    if (shape.type == engine::ShapeType::plane) {
        const Vec3 normal = pose.rotation * shape.normal;
        const double offset = normal.dot(pose.position);
        frame.grounds.push_back({true, drawn(normal), static_cast<float>(offset), i});
        return;
    }
    render::Solid solid;
    const float r = static_cast<float>(shape.radius);
    if (shape.type == engine::ShapeType::box) {
        solid.halfSize = drawn(shape.halfSize);
    } else if (shape.type == engine::ShapeType::sphere) {
        solid.shape = render::SolidShape::sphere;
        solid.halfSize = {r, r, r};
    } else {
        solid.shape = render::SolidShape::capsule;
        solid.halfSize = {r, static_cast<float>(shape.halfLength), r};
    }
    solid.position = drawn(pose.position);
    solid.rotation = pose.rotation.cast<float>();
    solid.color = colorOf(stage, i);
    solid.id = i;
    frame.solids.push_back(solid);
}

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
        {drawn(stage.world.pose(body).position), drawn(anchor), 0.025f, render::jointColor()});
}

void addJoint(const Stage& stage, engine::JointId id, const Overlays& overlays,
              render::Frame& frame) {
    const engine::JointState joint = stage.world.joint(id);
    if (joint.removed) return;
    if (joint.def.type == engine::JointType::distance)
        frame.rods.push_back(
            {drawn(joint.worldA), drawn(joint.worldB), 0.025f, render::jointColor()});
    addArm(stage, joint.def.a, joint.def.anchorA, joint.worldA, frame);
    addArm(stage, joint.def.b, joint.def.anchorB, joint.worldB, frame);
    if (!overlays.joints) return;
    frame.markers.push_back({drawn(joint.worldA), 4.5f, render::jointColor()});
    frame.markers.push_back({drawn(joint.worldB), 3.0f, render::normalColor()});
}

void addContacts(const Stage& stage, const Overlays& overlays, double scale, render::Frame& frame) {
    constexpr double kLeast = 0.01;  // m: shorter arrows are specks
    for (const engine::ContactState& contact : stage.world.contacts()) {
        const Vec3& at = contact.position;
        if (overlays.contacts && contact.impulse > 0.0)
            frame.markers.push_back({drawn(at), 3.5f, render::contactColor()});
        if (overlays.normals)
            frame.arrows.push_back(
                {drawn(at), drawn(at + 0.3 * contact.normal), render::normalColor()});
        const Vec3 push = contact.impulse / scale * contact.normal;
        if (overlays.impulses && push.norm() > kLeast)
            frame.arrows.push_back({drawn(at), drawn(at + push), render::impulseColor()});
        const Vec3 drag = contact.friction / scale;
        if (overlays.friction && drag.norm() > kLeast)
            frame.arrows.push_back({drawn(at), drawn(at + drag), render::frictionColor()});
    }
}

void addNudges(const Stage& stage, const History& history, double scale, render::Frame& frame) {
    for (std::size_t i = 0; i < history.nudges.size() && i < stage.bodies.size(); ++i) {
        const Vec3& at = stage.world.pose(stage.bodies[i]).position;
        const Vec3 way = history.nudges[i] / scale;
        if (way.norm() > 0.01) frame.arrows.push_back({drawn(at), drawn(at + way), nudgeColor()});
    }
}

void addAxes(const Stage& stage, render::Frame& frame) {
    const render::Color colors[] = {render::fromHex(0xd62728), render::fromHex(0x2f9e73),
                                    render::fromHex(0x1f77d0)};
    for (const engine::BodyId id : stage.bodies) {
        const engine::Pose& pose = stage.world.pose(id);
        if (stage.world.def(id).shape.type == engine::ShapeType::plane) continue;
        for (int axis = 0; axis < 3; ++axis)
            frame.arrows.push_back(
                {drawn(pose.position), drawn(pose.toWorld(0.6 * Vec3::Unit(axis))), colors[axis]});
    }
}

void addTrails(const Stage& stage, render::Frame& frame) {
    for (std::size_t i = 0; i < stage.trails.size(); ++i) {
        if (stage.trails[i].size() < 2) continue;
        render::Trail trail;
        for (const Vec3& point : stage.trails[i]) trail.points.push_back(drawn(point));
        const std::string& name = stage.scene.look.trails[i];
        for (std::size_t body = 0; body < stage.scene.bodies.size(); ++body)
            if (stage.scene.bodies[body].name == name)
                trail.color = colorOf(stage, static_cast<int>(body));
        frame.trails.push_back(std::move(trail));
    }
}

render::Camera cameraOf(const Stage& stage, double time) {
    const CameraDescription& camera = stage.scene.camera;
    Vec3 moved = Vec3::Zero();
    for (std::size_t i = 0; i < stage.bodies.size(); ++i)
        if (!camera.follow.empty() && stage.scene.bodies[i].name == camera.follow)
            moved = stage.world.pose(stage.bodies[i]).position -
                    stage.scene.bodies[i].def.pose.position;
    const double angle = camera.orbitDegreesPerSecond * time * std::numbers::pi / 180.0;
    const Eigen::AngleAxisd turn(angle, Vec3::UnitY());
    const Vec3 from = camera.lookAt + turn * (camera.from - camera.lookAt);
    render::Camera result;
    result.from = drawn(from + moved);
    result.lookAt = drawn(camera.lookAt + moved);
    result.fovDegrees = static_cast<float>(camera.fovDegrees);
    return result;
}

std::string captionAt(const SceneDescription& scene, double time) {
    std::string caption = scene.title;
    for (const Section& section : scene.sections)
        if (section.at <= time + 1e-9 && !section.caption.empty()) caption = section.caption;
    return caption;
}

const render::Color kInk = render::Text{}.color;

std::string counted(int count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

void addTexts(const Stage& stage, double time, render::Frame& frame) {
    const engine::Settings& settings = stage.world.settings();
    const int bodies = static_cast<int>(stage.bodies.size());
    frame.texts.push_back(
        {fmt::format("t = {:.3f} s   {}   {}, {}", time, counted(bodies, "body", "bodies"),
                     stage.scene.preset, counted(settings.substeps, "sub-step", "sub-steps")),
         render::Corner::topLeft, 18.0f, kInk});
    const std::string caption = captionAt(stage.scene, time);
    if (!caption.empty()) frame.texts.push_back({caption, render::Corner::bottomLeft, 26.0f, kInk});
}

void addStats(const Stage& stage, render::Frame& frame) {
    const engine::StepReport& report = stage.world.report();
    for (const std::string& line :
         {counted(report.contacts, "contact", "contacts"),
          fmt::format("penetration {:.2f} mm", 1e3 * report.worstPenetration),
          fmt::format("separation {:.2f} mm", 1e3 * report.worstSeparation),
          fmt::format("energy {:.4g} J", stage.world.energy().total())})
        frame.texts.push_back({line, render::Corner::topRight, 16.0f, kInk});
}

void addLegend(const Overlays& overlays, double impulseScale, double nudgeScale, bool nudged,
               render::Frame& frame) {
    if (overlays.impulses || overlays.friction)
        frame.texts.push_back({fmt::format("arrow 1 m = {:g} N s", impulseScale),
                               render::Corner::topLeft, 16.0f, render::impulseColor()});
    if (overlays.nudges)
        frame.texts.push_back(
            {nudged ? fmt::format("nudge 1 m = {:g} mm", 1e3 * nudgeScale) : "no nudges so far",
             render::Corner::topLeft, 16.0f, nudgeColor()});
}

}  // namespace

double arrowScale(double largest) {
    if (!(largest > 1e-6)) return 1.0;  // N s; less is rounding
    double decade = 1.0;
    while (decade > largest) decade /= 10.0;
    while (decade * 10.0 < largest) decade *= 10.0;
    for (const double step : {1.0, 2.5, 5.0})
        if (step * decade >= largest) return step * decade;
    return 10.0 * decade;
}

render::Frame snapshot(const Stage& stage, const Overlays& overlays, double frameTime,
                       const History& history) {
    constexpr double kLongestArrow = 2.0;  // m
    const double impulseScale = arrowScale(history.largestImpulse / kLongestArrow);
    const double nudgeScale = arrowScale(history.largestNudge / kLongestArrow);
    render::Frame frame;
    frame.camera = cameraOf(stage, frameTime);
    for (std::size_t i = 0; i < stage.bodies.size(); ++i)
        addBody(stage, static_cast<int>(i), frame);
    for (const engine::JointId id : stage.joints) {
        const std::size_t first = frame.rods.size();
        addJoint(stage, id, overlays, frame);
        for (std::size_t i = first; i < frame.rods.size(); ++i)  // numbered after the bodies
            frame.rods[i].id = static_cast<int>(stage.bodies.size()) + id.index;
    }
    if (overlays.trails) addTrails(stage, frame);
    addContacts(stage, overlays, impulseScale, frame);
    if (overlays.nudges) addNudges(stage, history, nudgeScale, frame);
    if (overlays.axes) addAxes(stage, frame);
    if (overlays.text) addTexts(stage, frameTime, frame);
    if (overlays.text)
        addLegend(overlays, impulseScale, nudgeScale, history.largestNudge > 0.0, frame);
    if (overlays.stats) addStats(stage, frame);
    applyTheme(overlays.theme, frame);
    return frame;
}

}  // namespace demos
