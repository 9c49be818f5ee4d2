#include "demos/play/falls.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "demos/text/plural.h"

namespace demos {
namespace {

constexpr double kFarBelow = 100.0;  // m, below what is fixed: nobody looks there
constexpr double kFallTime = 3.0;    // s
constexpr double kFree = 0.5;        // of gravity: a body that accelerates more is not carried

/// How far a point is below a body that could stop a fall; nothing if it could not.
std::optional<double> depthBelow(const engine::BodyDef& def, const engine::Pose& pose,
                                 const Vec3& point, const Vec3& up) {
    constexpr double kSteep = 0.01;
    if (def.kind == engine::BodyKind::dynamic || def.sensor || !def.collide) return {};
    if (def.shape.type != engine::ShapeType::plane)
        return (pose.position - point).dot(up) - engine::reachOf(def.shape);
    const Vec3 normal = pose.rotation * def.shape.normal;
    if (normal.dot(up) < kSteep) return {};
    return normal.dot(pose.position - point) / normal.dot(up);
}

struct Fall {
    double depth = 0.0;     // m
    bool anyFixed = false;  // the depth is below what is fixed; else below the start
};

Fall fallOf(const Stage& stage, std::size_t body, const Vec3& up) {
    const Vec3& point = stage.world.pose(stage.bodies[body]).position;
    std::optional<double> least;
    for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
        if (!stage.world.has(stage.bodies[i])) continue;
        const auto depth = depthBelow(stage.scene.bodies[i].def, stage.world.pose(stage.bodies[i]),
                                      point, up);
        if (depth) least = std::min(least.value_or(*depth), *depth);
    }
    if (least) return {*least, true};
    return {(stage.scene.bodies[body].def.pose.position - point).dot(up), false};
}

}  // namespace

void Falls::look(const Stage& stage) {
    const double left = stage.scene.seconds - stage.world.report().time;
    if (left > 1.5 * stage.dt()) return;  // only the last two steps matter
    before_ = std::move(velocities_);
    velocities_.clear();
    for (const engine::BodyId id : stage.bodies)
        velocities_.push_back(stage.world.has(id) ? stage.world.velocity(id) : Vec3::Zero());
}

std::string Falls::line(const Stage& stage) const {
    const double gravity = stage.world.gravity().norm();
    if (gravity == 0.0 || before_.size() != stage.bodies.size()) return {};
    const Vec3 down = stage.world.gravity() / gravity;
    const double ownFall = 0.5 * gravity * kFallTime * kFallTime;
    std::size_t count = 0, first = 0;
    Fall fall;
    for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
        const bool movable = stage.scene.bodies[i].def.kind == engine::BodyKind::dynamic;
        const double gained = (velocities_[i] - before_[i]).dot(down);
        if (!movable || velocities_[i].dot(down) <= 0.0 || gained < kFree * gravity * stage.dt())
            continue;
        const Fall its = fallOf(stage, i, -down);
        if (its.depth < (its.anyFixed ? kFarBelow : ownFall)) continue;
        if (count++ == 0) first = i, fall = its;
    }
    if (count == 0) return {};
    const std::string others =
        count == 1 ? "" : fmt::format(" and {}", plural(count - 1, "other body", "other bodies"));
    return fmt::format("{}: '{}'{} {} out of the scene: {:.3g} m below {} after {:.3g} s; a floor is "
                       "a body with shape = {{ plane = [0, 1, 0] }} and fixed = true",
                       stage.scene.name, stage.scene.bodies[first].name, others,
                       count == 1 ? "falls" : "fall", fall.depth,
                       fall.anyFixed ? "everything fixed" : "the start",
                       stage.world.report().time);
}

}  // namespace demos
