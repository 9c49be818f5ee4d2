// Bodies as solids and grounds, and their earlier poses as ghosts.
#include <algorithm>

#include "demos/snapshot/colors.h"
#include "demos/snapshot/parts.h"

namespace demos {
namespace {

constexpr float kFaintest = 0.12f, kDensest = 0.34f;  // alpha of the oldest and newest ghost
constexpr double kLeastWay = 0.3;  // of its reach, that a body moves between two ghosts

render::Ground groundOf(const engine::Shape& plane, const engine::Pose& pose, int id) {
    const Vec3 normal = pose.rotation * plane.normal;
    return {true, drawn(normal), static_cast<float>(normal.dot(pose.position)), id};
}

render::Solid solidOf(const engine::Shape& shape, const engine::Pose& pose,
                      const render::Color& color, int id) {
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
    solid.color = color;
    solid.id = id;
    return solid;
}

/// How far the farthest point of a body goes from one pose to another, about.
double wayBetween(const engine::Pose& a, const engine::Pose& b, double reach) {
    return (a.position - b.position).norm() + a.rotation.angularDistance(b.rotation) * reach;
}

/// A sensor lets through what is behind it.
void addSolid(const Stage& stage, std::size_t i, render::Color color, render::Frame& frame) {
    const engine::BodyDef& def = stage.world.def(stage.bodies[i]);
    if (def.sensor) color.a = kDensest;
    (def.sensor ? frame.ghosts : frame.solids)
        .push_back(solidOf(def.shape, stage.world.pose(stage.bodies[i]), color,
                           static_cast<int>(i)));
}

}  // namespace

double thicknessOf(const engine::Shape& shape) {
    if (shape.type == engine::ShapeType::plane) return 0.0;
    return shape.type == engine::ShapeType::box ? shape.halfSize.minCoeff() : shape.radius;
}

void addBodies(const Moment& moment, render::Frame& frame) {
    const Stage& stage = moment.stage;
    const std::vector<render::Color> colors = bodyColors(stage, moment.overlays, moment.history);
    for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
        const engine::Shape& shape = stage.world.def(stage.bodies[i]).shape;
        const engine::Pose& pose = stage.world.pose(stage.bodies[i]);
        if (shape.type == engine::ShapeType::plane)
            frame.grounds.push_back(groundOf(shape, pose, static_cast<int>(i)));
        else
            addSolid(stage, i, colors[i], frame);
    }
}

void addGhosts(const Moment& moment, render::Frame& frame) {
    const Stage& stage = moment.stage;
    const auto& ghosts = moment.history.ghosts;
    const std::vector<render::Color> colors = bodyColors(stage, moment.overlays, moment.history);
    for (std::size_t age = 0; age < ghosts.size(); ++age)
        for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
            const engine::Shape& shape = stage.world.def(stage.bodies[i]).shape;
            const double reach = reachOf(shape), least = kLeastWay * reach;
            const engine::Pose& pose = ghosts[age][i];
            const engine::Pose& now = stage.world.pose(stage.bodies[i]);
            const engine::Pose& newer = age + 1 < ghosts.size() ? ghosts[age + 1][i] : now;
            if (shape.type == engine::ShapeType::plane || wayBetween(pose, now, reach) <= least ||
                wayBetween(pose, newer, reach) <= least)
                continue;
            render::Color color = colors[i];
            const float share = static_cast<float>(age + 1) / static_cast<float>(ghosts.size());
            color.a = kFaintest + share * (kDensest - kFaintest);
            frame.ghosts.push_back(solidOf(shape, pose, color, static_cast<int>(i)));
        }
}

}  // namespace demos
