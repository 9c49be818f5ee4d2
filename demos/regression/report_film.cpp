#include "demos/regression/report_film.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "demos/regression/report_views.h"
#include "demos/text/rounded.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kMostMoments = 120, kFewestMoments = 24;
constexpr long kPose = 6;                   // numbers: x, y, z and three of the rotation
constexpr long kExtent = 3;                 // numbers
constexpr long kCurves = 4 * kMostMoments;  // numbers: step, energy, penetration, separation

/// A body as the film shows it.
struct FilmBody {
    std::string name;
    double way = 0.0;  // m, the largest distance from its first position
};

bool hasBox(const Trajectory& trajectory, std::size_t body) {
    return body < trajectory.extents.size() && trajectory.extents[body].any();
}

double farthest(const Trajectory& trajectory, std::size_t body) {
    double way = 0.0;
    for (const TrajectoryMoment& moment : trajectory.moments) {
        const Vec3 moved =
            moment.poses[body].position - trajectory.moments.front().poses[body].position;
        const auto turned = static_cast<double>(moment.poses[body].rotation.angularDistance(
            trajectory.moments.front().poses[body].rotation));
        const double extent = static_cast<double>(trajectory.extents[body].norm());
        way = std::max(way, static_cast<double>(moved.norm()) + turned * extent);
    }
    return way;
}

/// Bodies of both runs: those in `matter` first, then those that move farthest.
std::vector<FilmBody> rankedBodies(const ReportTrajectories& trajectories,
                                   const std::set<std::string>& matter) {
    std::map<std::string, double> ways;
    for (const Trajectory* trajectory : {&trajectories.actual, &trajectories.baseline})
        for (std::size_t i = 0; i < trajectory->bodies.size() && !trajectory->moments.empty(); ++i)
            if (hasBox(*trajectory, i)) {
                double& way = ways[trajectory->bodies[i]];
                way = std::max(way, farthest(*trajectory, i));
            }
    std::vector<FilmBody> bodies;
    for (const auto& [name, way] : ways) bodies.push_back({name, way});
    const auto rank = [&](const FilmBody& b) { return std::pair(matter.contains(b.name), b.way); };
    std::stable_sort(bodies.begin(), bodies.end(),
                     [&](const FilmBody& a, const FilmBody& b) { return rank(a) > rank(b); });
    return bodies;
}

bool moves(const FilmBody& body) { return body.way > 1e-6; }

/// How many moments each run gets if it may have `numbers` numbers.
int momentsFor(const std::vector<FilmBody>& bodies, long numbers) {
    const auto moving = std::count_if(bodies.begin(), bodies.end(), moves);
    const long still = (static_cast<long>(bodies.size()) - moving) * (kPose + kExtent);
    const long fit = (numbers - kCurves - still) / std::max(1L, kPose * static_cast<long>(moving));
    return static_cast<int>(std::clamp<long>(fit, kFewestMoments, kMostMoments));
}

std::set<std::string> shownBodies(const std::vector<FilmBody>& bodies, int moments, long numbers) {
    std::set<std::string> shown;
    long left = numbers - kCurves;
    for (const FilmBody& body : bodies) {
        const long cost = kExtent + kPose * (moves(body) ? moments : 1);
        if (cost > left) continue;
        left -= cost;
        shown.insert(body.name);
    }
    return shown;
}

/// Indices of moments spaced evenly over the run, with its ends and the moment of `step`.
std::vector<std::size_t> thinned(const Trajectory& trajectory, int count, int step) {
    std::set<std::size_t> kept;
    const std::size_t last = trajectory.moments.size() - 1;
    for (int i = 0; i < count; ++i)
        kept.insert(last * static_cast<std::size_t>(i) / static_cast<std::size_t>(count - 1));
    for (std::size_t i = 0; i <= last; ++i)
        if (trajectory.moments[i].step == step) kept.insert(i);
    return {kept.begin(), kept.end()};
}

double reach(const Trajectory& trajectory) {
    double largest = 0.0;
    for (const TrajectoryMoment& moment : trajectory.moments)
        for (const engine::Pose& pose : moment.poses)
            if (pose.position.allFinite())
                largest =
                    std::max(largest, static_cast<double>(pose.position.cwiseAbs().maxCoeff()));
    return largest;
}

/// Four digits: a curve shows no more than three.
Json shortOf(double value) {
    return std::isfinite(value) ? Json(rounded(value, 4)) : Json(nullptr);
}

long inUnits(double value, double unit) {
    return std::isfinite(value) ? std::lround(value / unit) : 0;
}

void addPose(Json& numbers, const engine::Pose& pose, double unit) {
    for (int i = 0; i < 3; ++i)
        numbers.push_back(inUnits(static_cast<double>(pose.position[i]), unit));
    const double sign = std::signbit(pose.rotation.w()) ? -1.0 : 1.0;
    for (int i = 0; i < 3; ++i)
        numbers.push_back(inUnits(sign * static_cast<double>(pose.rotation.coeffs()[i]), 1e-3));
}

/// A body that does not move gets a single pose.
Json posesOf(const Trajectory& trajectory, std::size_t body, const std::vector<std::size_t>& kept,
             double unit) {
    Json numbers = Json::array(), first = Json::array();
    bool same = true;
    for (const std::size_t moment : kept) {
        Json pose = Json::array();
        addPose(pose, trajectory.moments[moment].poses[body], unit);
        if (numbers.empty()) first = pose;
        same = same && pose == first;
        numbers.insert(numbers.end(), pose.begin(), pose.end());
    }
    return same ? first : numbers;
}

void addBodies(Json& json, const Trajectory& trajectory, const std::set<std::string>& shown,
               const std::vector<std::size_t>& kept, double unit) {
    for (std::size_t i = 0; i < trajectory.bodies.size(); ++i) {
        if (!hasBox(trajectory, i) || !shown.contains(trajectory.bodies[i])) continue;
        Json extent = Json::array();
        for (int axis = 0; axis < 3; ++axis)
            extent.push_back(shortOf(static_cast<double>(trajectory.extents[i][axis])));
        json["bodies"].push_back({{"name", trajectory.bodies[i]},
                                  {"extent", extent},
                                  {"poses", posesOf(trajectory, i, kept, unit)}});
    }
}

/// Penetration and separation are the largest since the moment before, so that no peak is lost.
void addCurves(Json& json, const Trajectory& trajectory, int step) {
    for (const char* key : {"steps", "energy", "penetration", "separation"})
        json[key] = Json::array();
    std::size_t next = 0;
    for (const std::size_t i : thinned(trajectory, kMostMoments, step)) {
        double penetration = 0.0, separation = 0.0;
        for (; next <= i; ++next) {
            penetration = std::max(penetration, trajectory.moments[next].penetration);
            separation = std::max(separation, trajectory.moments[next].separation);
        }
        json["steps"].push_back(trajectory.moments[i].step);
        json["energy"].push_back(shortOf(trajectory.moments[i].energy));
        json["penetration"].push_back(shortOf(penetration));
        json["separation"].push_back(shortOf(separation));
    }
}

struct Thinning {
    std::set<std::string> bodies;
    int moments = kMostMoments;
    int step = -1;      // its moment is kept
    double unit = 1.0;  // m
};

Json trajectoryJson(const Trajectory& trajectory, const Thinning& thinning) {
    if (trajectory.moments.empty()) return nullptr;
    Json json{
        {"hz", trajectory.hz}, {"all_bodies", trajectory.bodies.size()}, {"bodies", Json::array()}};
    addCurves(json, trajectory, thinning.step);
    const std::vector<std::size_t> kept = thinned(trajectory, thinning.moments, thinning.step);
    json["pose_steps"] = Json::array();
    for (const std::size_t i : kept) json["pose_steps"].push_back(trajectory.moments[i].step);
    addBodies(json, trajectory, thinning.bodies, kept, thinning.unit);
    return json;
}

double endOf(const Trajectory& trajectory) {
    return trajectory.moments.empty() ? 0.0 : 1.0 * trajectory.moments.back().step / trajectory.hz;
}

}  // namespace

Json filmOf(const ReportTrajectories& trajectories, const PhysicsVerdict& physics, long numbers) {
    const bool had = !trajectories.baseline.moments.empty(),
               has = !trajectories.actual.moments.empty();
    if (!had && !has) return nullptr;
    const bool same = had && has && physics.kind == PhysicsVerdict::Kind::same;
    const double end = std::max(endOf(trajectories.baseline), endOf(trajectories.actual));
    Json views = viewsJson(trajectories.camera, end);
    const long left = numbers - static_cast<long>(views.size() * views.front().size());
    const long share = had && has && !same ? left / 2 : left;
    const std::string& follow = trajectories.camera.follow;
    const std::vector<FilmBody> bodies = rankedBodies(trajectories, {physics.body, follow});
    Thinning thinning;
    thinning.moments = momentsFor(bodies, share);
    thinning.bodies = shownBodies(bodies, thinning.moments, share);
    thinning.step = physics.step;
    const double farthestPlace = std::max(reach(trajectories.baseline), reach(trajectories.actual));
    thinning.unit = std::max(farthestPlace, 1e-3) / 32767.0;
    return {{"views", std::move(views)},
            {"follow", follow},
            {"unit", thinning.unit},
            {"same", same},
            {"baseline", same ? Json(nullptr) : trajectoryJson(trajectories.baseline, thinning)},
            {"actual", trajectoryJson(trajectories.actual, thinning)}};
}

}  // namespace demos
