// kinematic = { velocity, spin }, { path, times, ... } or { orbit }

#include "demos/scene/ranges.h"
#include "demos/scene/table_readers.h"
#include "engine/base/trigonometry.h"

namespace demos {
namespace {

std::optional<std::vector<Vec3>> readPoints(Keys& keys) {
    const std::optional<std::vector<Vec3>> points = keys.vectors("path", kMeters);
    if (!points || points->size() >= 2) return points;
    keys.complain("path", "path should be at least two points, like [[0, 1, 0], [4, 1, 0]]");
    return std::nullopt;
}

/// Empty after an error.
std::vector<double> readTimes(Keys& keys, std::size_t points) {
    if (!keys.has("times"))
        keys.complain("path", "a path has no times; write times = [0, 2, ...], one per point, "
                              "in s");
    const std::optional<std::vector<double>> times = keys.numbers("times", {0.0, 1e5, "s"});
    if (!times) return {};
    bool rising = !times->empty() && times->front() == 0.0;
    for (std::size_t i = 1; i < times->size(); ++i)
        rising = rising && (*times)[i] > (*times)[i - 1];
    if (times->size() == points && rising) return *times;
    keys.complain("times", "there are " + std::to_string(times->size()) + " times for " +
                               std::to_string(points) +
                               " points; they should be as many, begin with 0 and rise");
    return {};
}

std::optional<PointPath> readPointPath(Keys& keys, const Instance& instance) {
    const auto points = readPoints(keys);
    PointPath path;
    path.loop = keys.truth("loop").value_or(false);
    path.smooth = keys.truth("smooth").value_or(false);
    path.spin = keys.vector("spin", kSpin).value_or(Vec3(0, 0, 0));
    if (!points) {
        keys.any("times");
        return std::nullopt;
    }
    path.times = readTimes(keys, points->size());
    if (path.times.empty()) return std::nullopt;
    if (path.loop && points->front() != points->back()) {
        keys.complain("loop", "a path that loops should end where it began; write its first point "
                              "again at the end, with a time of its own");
        return std::nullopt;
    }
    for (const Vec3& point : *points) path.points.push_back(instance.point(point));
    return path;
}

std::optional<Orbit> readOrbit(Keys keys, const Instance& instance) {
    if (!keys.has("centre") || !keys.has("deg_per_s"))
        keys.complain("centre", "an orbit needs centre and deg_per_s; write "
                                "orbit = { centre = [0, 1, 0], axis = [0, 1, 0], deg_per_s = 90 }");
    Orbit orbit;
    const std::optional<Vec3> centre = keys.vector("centre", kMeters);
    const Vec3 axis = keys.vector("axis", {-1e6, 1e6}).value_or(Vec3(0, 1, 0));
    const std::optional<double> rate = keys.number("deg_per_s", {-36'000.0, 36'000.0, "deg/s"});
    orbit.turns = keys.truth("turn").value_or(true);
    if (axis.norm() < 1e-6)
        keys.complain("axis", "axis is [0, 0, 0]; it should be a direction, like [0, 1, 0]");
    keys.done();
    if (!centre || !rate || axis.norm() < 1e-6) return std::nullopt;
    orbit.centre = instance.point(*centre);
    orbit.axis = instance.direction(axis.normalized());
    orbit.rate = engine::radians(*rate);
    return orbit;
}

}  // namespace

void readKinematic(Keys keys, const Instance& instance, BodyDescription& body) {
    const Value* orbit = keys.any("orbit");
    const bool path = keys.has("path");
    if (path) body.path = readPointPath(keys, instance);
    if (orbit) body.path = readOrbit(keys.inner(*orbit, "an orbit"), instance);
    if (path && orbit) keys.complain("orbit", "path and orbit in one body; give one of them");
    for (const char* key : {"velocity", "spin"})
        if (keys.has(key) && (orbit || (path && key == std::string("velocity")))) {
            keys.any(key);
            keys.complain(key, std::string(key) + " of a body on " +
                                   (orbit ? "an orbit" : "a path") + "; leave it out");
        }
    if (!path && !orbit) {
        body.def.velocity = keys.vector("velocity", kSpeed).value_or(Vec3(0, 0, 0));
        body.def.spin = keys.vector("spin", kSpin).value_or(Vec3(0, 0, 0));
    }
    keys.done();
}

}  // namespace demos
