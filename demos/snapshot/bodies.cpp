// Bodies as solids and grounds, and their earlier poses as ghosts.
#include <algorithm>

#include "demos/snapshot/colors.h"
#include "demos/snapshot/frame_parts.h"
#include "engine/shapes/hull.h"

namespace demos {
namespace {

constexpr float kFaintest = 0.12f, kDensest = 0.34f;  // alpha of the oldest and newest ghost
constexpr double kLeastWay = 0.3;  // of its reach: the least movement of a body between two ghosts

render::Ground groundOf(const engine::Shape& plane, const engine::Pose& pose, int id) {
    const Vec3 normal = pose.rotation * plane.normal;
    return {true, drawn(normal), static_cast<float>(normal.dot(pose.position)), id};
}

/// Adds a body's solids at `pose`.
void place(const std::vector<DrawnPart>& parts, const engine::Pose& pose,
           const render::Color& color, render::Material look, int id,
           std::vector<render::Solid>& out) {
    for (const DrawnPart& part : parts) {
        render::Solid& solid = out.emplace_back(part.solid);
        solid.position = drawn(pose.toWorld(part.place.position));
        solid.rotation = (pose.rotation * part.place.rotation).cast<float>();
        solid.color = color;
        solid.material = look;
        solid.id = id;
    }
}

/// Approximately how far the farthest point of a body moves from one pose to another.
double wayBetween(const engine::Pose& a, const engine::Pose& b, double reach) {
    return (a.position - b.position).norm() + a.rotation.angularDistance(b.rotation) * reach;
}

void addSolid(const Stage& stage, std::size_t i, render::Color color, render::Frame& frame) {
    const engine::BodyDef& def = stage.world.def(stage.bodies[i]);
    if (def.sensor) color.a = kSensorAlpha;
    place(stage.drawn[i], stage.world.pose(stage.bodies[i]), color, stage.scene.bodies[i].look,
          static_cast<int>(i), def.sensor ? frame.ghosts : frame.solids);
}

}  // namespace

double thicknessOf(const engine::Shape& shape) {
    switch (shape.type) {
        case engine::ShapeType::plane:
        case engine::ShapeType::mesh: return 0.0;
        case engine::ShapeType::box: return shape.halfSize.minCoeff();
        case engine::ShapeType::cylinder: return std::min(shape.radius, shape.halfLength);
        case engine::ShapeType::cone: return 0.5 * std::min(shape.radius, shape.halfLength);
        case engine::ShapeType::hull: {
            double least = reachOf(shape);
            for (const engine::Hull::Face& face : shape.hull->faces)
                least = std::min(least, face.offset);
            return least;
        }
        case engine::ShapeType::compound: return 0.3 * reachOf(shape);  // it may be hollow
        default: return shape.radius;
    }
}

void addBodies(const Moment& moment, render::Frame& frame) {
    const Stage& stage = moment.stage;
    const std::vector<render::Color> colors = bodyColors(stage, moment.overlays, moment.history);
    for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
        if (!stage.world.has(stage.bodies[i])) continue;  // it was removed after an incident
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
            place(stage.drawn[i], pose, color, stage.scene.bodies[i].look, static_cast<int>(i),
                  frame.ghosts);
        }
}

}  // namespace demos
