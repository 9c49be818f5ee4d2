#include "demos/play/motion_camera.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "demos/processes/signals.h"
#include "engine/base/trigonometry.h"
#include "engine/shapes/bounds.h"

namespace demos {
namespace {

constexpr double kFilled = 0.7;            // of the picture, by the box of all motion
constexpr double kAspect = 16.0 / 9.0;     // of that picture
constexpr double kAway = 3.0;              // times as far as most bodies: left for ever
constexpr double kAwayAtStart = 5.0;       // the same before the first step: it will come nearer
constexpr double kCutShare = 0.02;         // of all samples, at either end of the box
constexpr double kDeep = 1.5;              // times as deep as wide: seen from the other side
constexpr double kLeastRadius = 0.02;      // m
constexpr std::size_t kMostSamples = 200'000;
constexpr int kMostTimes = 120;

using Sample = RunMotion::Sample;

/// The k-th smallest, from 0; reorders the values.
double smallest(std::vector<double>& values, std::size_t k) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k), values.end());
    return values[k];
}

/// The same with k as a share of the number.
double quantile(std::vector<double>& values, double share) {
    const double k = share * static_cast<double>(values.size() - 1);
    return smallest(values, static_cast<std::size_t>(k));
}

template <class Place>
Vec3 medianPlace(std::size_t count, Place place) {
    Vec3 middle;
    std::vector<double> values(count);
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < count; ++i) values[i] = place(i)[axis];
        middle[axis] = quantile(values, 0.5);
    }
    return middle;
}

bool moves(const BodyDescription& body) {
    return body.def.kind != engine::BodyKind::fixed &&
           body.def.shape.type != engine::ShapeType::plane;
}

bool hasAnchor(engine::JointType type) {
    return type != engine::JointType::gear && type != engine::JointType::axis;
}

void addStill(const SceneDescription& scene, RunMotion& motion) {
    for (const BodyDescription& body : scene.bodies)
        if (!moves(body) && body.def.shape.type != engine::ShapeType::plane)
            motion.fixed.push_back({&body, 0, body.def.pose, true});
    for (const auto& [name, def, place] : scene.joints) {
        if (!hasAnchor(def.type)) continue;
        if (def.a.index < 0) motion.anchors.push_back(def.anchorA);
        if (def.b.index < 0) motion.anchors.push_back(def.anchorB);
    }
}

/// `way`: how far the camera has followed.
void addSamples(const SceneDescription& scene, const Stage& stage, const Vec3& way, bool first,
                RunMotion& motion) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!moves(scene.bodies[i]) || !stage.world.has(stage.bodies[i])) continue;
        engine::Pose pose = stage.world.pose(stage.bodies[i]);
        pose.position -= way;
        motion.moving.push_back({&scene.bodies[i], static_cast<int>(i), pose, first});
    }
}

long stepsOf(const SceneDescription& scene) { return std::lround(scene.seconds * scene.hz); }

/// Steps between two samples of this scene.
long stride(const SceneDescription& scene, std::size_t scenes) {
    const std::size_t bodies = std::max<std::size_t>(scene.bodies.size() * scenes, 1);
    const int times = std::clamp(static_cast<int>(kMostSamples / bodies), 8, kMostTimes);
    return std::max(stepsOf(scene) / times, 1L);
}

/// What half of the bodies never exceed; 0 without bodies.
double usualOf(const std::map<int, double>& farthest) {
    std::vector<double> distances;
    for (const auto& [body, far] : farthest) distances.push_back(far);
    return distances.empty() ? 0.0 : smallest(distances, distances.size() / 2);
}

/// Bodies that have left count while they are near the others: within kAway times the distance from
/// the middle that half of the bodies never exceed; of two bodies none is the one that has left.
/// Where only few bodies move, they are what the picture is about: half of their starts are near.
void dropFar(RunMotion& motion) {
    const std::vector<Sample>& all = motion.moving;
    const Vec3 middle =
        medianPlace(all.size(), [&](std::size_t i) { return all[i].pose.position; });
    const auto distance = [&](const Sample& sample) {
        return (sample.pose.position - middle).norm() + engine::reachOf(sample.shape());
    };
    std::map<int, double> farthest, started;
    std::map<int, Vec3> starts;
    for (const Sample& sample : all) {
        farthest[sample.number] = std::max(farthest[sample.number], distance(sample));
        const Vec3 start = starts.try_emplace(sample.number, sample.pose.position).first->second;
        if ((sample.pose.position - start).norm() > engine::reachOf(sample.shape()))
            started.try_emplace(sample.number, (start - middle).norm());
    }
    const double usual = std::max(usualOf(farthest), usualOf(started));
    std::erase_if(motion.moving, [&](const Sample& sample) {
        return distance(sample) > (sample.first ? kAwayAtStart : kAway) * usual;
    });
    std::erase_if(motion.anchors, [&](const Vec3& anchor) {
        return (anchor - middle).norm() > kAwayAtStart * usual;
    });
}

/// World to view: x right, y up, z towards the camera, which looks along -`back`.
Quat viewOf(const Vec3& back) {
    const Vec3 right = Vec3::UnitY().cross(back).normalized();
    Eigen::Matrix3d axes;
    axes << right.transpose(), back.cross(right).transpose(), back.transpose();
    return Quat(axes).normalized();
}

engine::Bounds boundsIn(const Quat& view, const Sample& sample) {
    return engine::boundsOf(sample.shape(), {view * sample.pose.position,
                                             (view * sample.pose.rotation).normalized()});
}

/// The largest value of most samples, of all before the first step, and of the anchors.
/// `value`: of bounds in view axes.
template <class Value>
double most(const RunMotion& motion, const Quat& view, Value value) {
    double largest = -1e300;
    std::vector<double> all;
    for (const Sample& sample : motion.moving) {
        all.push_back(value(boundsIn(view, sample)));
        if (sample.first) largest = std::max(largest, all.back());
    }
    for (const Vec3& anchor : motion.anchors)
        largest = std::max(largest, value(engine::Bounds{view * anchor, view * anchor}));
    return std::max(largest, quantile(all, 1.0 - kCutShare));
}

engine::Bounds boxOf(const RunMotion& motion, const Quat& view) {
    engine::Bounds box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = -most(motion, view, [=](const auto& one) { return -one.low[axis]; });
        box.high[axis] = most(motion, view, [=](const auto& one) { return one.high[axis]; });
    }
    return box;
}

/// Adds anchors and fixed bodies as if they moved, if they are near and not larger than the box.
void addScenery(const Quat& view, const engine::Bounds& box, RunMotion& motion) {
    const Vec3 centre = 0.5 * (box.low + box.high);
    const double radius = 0.5 * (box.high - box.low).norm();
    for (const Sample& sample : motion.fixed) {
        const engine::Bounds one = boundsIn(view, sample);
        const double away = (0.5 * (one.low + one.high) - centre).norm();
        if (away < 2.0 * radius && 0.5 * (one.high - one.low).norm() < radius)
            motion.moving.push_back(sample);
    }
}

/// From the front, a little aside and above; motion that is deeper than wide is seen from the side.
Vec3 backOf(const std::vector<Sample>& samples) {
    double size[3];
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> places;
        for (const Sample& sample : samples) places.push_back(sample.pose.position[axis]);
        size[axis] = quantile(places, 1.0 - kCutShare) - quantile(places, kCutShare);
    }
    const bool deep = size[2] > kDeep * size[0];
    return (deep ? Vec3(0.8, 0.32, 0.5) : Vec3(0.5, 0.32, 0.8)).normalized();
}

/// A point p is inside the filled share of the picture of a camera at c if, for x and y,
///     |p - c| <= k (c_z - p_z),   k = the share times the tangent of half the angle of view.
/// So, with r = max(p + k p_z) and l = min(p - k p_z),   c = (r + l) / 2,   c_z >= (r - l) / (2 k).
void place(const RunMotion& motion, const Quat& view, const Vec3& back, CameraDescription& camera) {
    const double angle = engine::radians(0.5 * camera.fovDegrees);
    const double tangent = engine::sine(angle) / engine::cosine(angle);
    const engine::Bounds box = boxOf(motion, view);
    const double depth = 0.5 * (box.low.z() + box.high.z());
    Vec3 from(0.0, 0.0, depth + kLeastRadius / tangent);
    for (const int axis : {0, 1}) {
        const double k = kFilled * tangent * (axis == 0 ? kAspect : 1.0);
        const double r = most(motion, view, [=](const engine::Bounds& one) {
            return one.high[axis] + k * one.high.z();
        });
        const double l = -most(motion, view, [=](const engine::Bounds& one) {
            return k * one.high.z() - one.low[axis];
        });
        from[axis] = 0.5 * (r + l);
        from.z() = std::max(from.z(), (r - l) / (2.0 * k));
    }
    camera.from = view.conjugate() * from;
    camera.lookAt = camera.from - (from.z() - depth) * back;
    camera.fitsMotion = false;
}

void fit(RunMotion& motion, std::span<CameraDescription* const> cameras) {
    if (motion.moving.empty()) motion.moving.swap(motion.fixed);
    if (motion.moving.empty()) return;
    dropFar(motion);
    const Vec3 back = backOf(motion.moving);
    const Quat view = viewOf(back);
    addScenery(view, boxOf(motion, view), motion);
    for (CameraDescription* camera : cameras) place(motion, view, back, *camera);
}

/// One run, without pictures.
RunMotion motionOfRun(const SceneDescription& scene, std::size_t scenes) {
    Stage stage(scene);
    MotionSampler sampler(scene, scenes);
    const long steps = stepsOf(scene);
    for (long step = 0; step <= steps && !interrupted(); ++step) {
        if (step > 0 && !stage.step()) break;
        sampler.look(stage, step);
    }
    return sampler.motion();
}

}  // namespace

MotionSampler::MotionSampler(const SceneDescription& scene, std::size_t scenes)
    : scene_(scene), every_(stride(scene, scenes)) {
    addStill(scene, motion_);
}

void MotionSampler::look(const Stage& stage, long step) {
    if (step == 0) start_ = middleOf(stage).value_or(Vec3::Zero());
    if (step % every_ != 0) return;
    const bool follows = scene_.camera.move == CameraMove::follow;
    const Vec3 way = follows ? Vec3(middleOf(stage).value_or(start_) - start_) : Vec3::Zero();
    addSamples(scene_, stage, way, step == 0, motion_);
}

CameraDescription MotionSampler::camera() const {
    RunMotion motion = motion_;
    CameraDescription camera = scene_.camera;
    CameraDescription* const fitted[] = {&camera};
    fit(motion, fitted);
    return camera;
}

std::optional<Vec3> middleOf(const Stage& stage) {
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < stage.bodies.size(); ++i)
        if (moves(stage.scene.bodies[i]) && stage.world.has(stage.bodies[i]))
            places.push_back(stage.world.pose(stage.bodies[i]).position);
    if (places.empty()) return std::nullopt;
    return medianPlace(places.size(), [&](std::size_t i) { return places[i]; });
}

void fitToMotion(std::span<SceneDescription* const> scenes) {
    RunMotion motion;
    std::vector<SceneDescription*> fitted;
    std::vector<CameraDescription*> cameras;
    for (SceneDescription* scene : scenes)
        if (scene->camera.fitsMotion) fitted.push_back(scene), cameras.push_back(&scene->camera);
    for (const SceneDescription* scene : fitted) {
        const RunMotion own = motionOfRun(*scene, fitted.size());
        motion.moving.insert(motion.moving.end(), own.moving.begin(), own.moving.end());
        motion.fixed.insert(motion.fixed.end(), own.fixed.begin(), own.fixed.end());
        motion.anchors.insert(motion.anchors.end(), own.anchors.begin(), own.anchors.end());
    }
    fit(motion, cameras);
}

}  // namespace demos
