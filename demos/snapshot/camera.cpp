// view(t) = a + e(s) (b - a),  s = (t - t_a) / (t_b - t_a)   between the keys a and b
//
//   smooth 3 s^2 - 2 s^3   linear s   in s^2   out 1 - (1 - s)^2   cut 0

#include "demos/snapshot/camera.h"

#include <algorithm>
#include <numbers>

#include "demos/look/key_light.h"

namespace demos {
namespace {

constexpr double kSameTime = 1e-9;      // s: times of pictures are sums, those of keys are not
constexpr double kPushShare = 0.12;     // of the distance to lookAt
constexpr double kOrbitDegrees = 25.0;  // half before and half after `from`
constexpr double kNearestFocus = 1e-3;  // m; a nearer point, or one behind, is not focused on

double eased(Ease ease, double s) {
    switch (ease) {
        case Ease::smooth:
            return s * s * (3.0 - 2.0 * s);
        case Ease::linear:
            return s;
        case Ease::in:
            return s * s;
        case Ease::out:
            return 1.0 - (1.0 - s) * (1.0 - s);
        case Ease::cut:
            return 0.0;
    }
    return s;
}

bool reached(const CameraKey& key, double time) { return key.at <= time + kSameTime; }

CameraView viewOf(const CameraKey& key) { return {key.from, key.lookAt, key.fovDegrees}; }

CameraView mixed(const CameraKey& a, const CameraKey& b, double share) {
    return {a.from + share * (b.from - a.from), a.lookAt + share * (b.lookAt - a.lookAt),
            a.fovDegrees + share * (b.fovDegrees - a.fovDegrees)};
}

/// How far the followed body, or the middle of those that move, has moved, with the camera's lag.
Vec3 followed(const Moment& moment) {
    const Stage& stage = moment.stage;
    const CameraDescription& camera = stage.scene.camera;
    if (camera.move == CameraMove::follow && moment.history.followed)
        return *moment.history.followed - *moment.history.followedFirst;
    for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
        if (camera.follow.empty() || stage.scene.bodies[i].name != camera.follow) continue;
        const Vec3 place = stage.world.pose(stage.bodies[i]).position;
        return moment.history.followed.value_or(place) - stage.scene.bodies[i].def.pose.position;
    }
    return Vec3::Zero();
}

/// m along the view axis; never 0, so that a shutter can interpolate it.
double focusOf(const Stage& stage, const Vec3& from, const Vec3& lookAt) {
    const CameraDescription& camera = stage.scene.camera;
    const Vec3 sight = lookAt - from;
    double focus = camera.focus;
    if (const std::optional<Vec3> place = placeOf(stage, camera.focusBody))
        focus = sight.normalized().dot(*place - from);
    return focus > kNearestFocus ? focus : sight.norm();
}

}  // namespace

CameraView viewAt(const CameraDescription& camera, double time) {
    CameraKey before{0.0, camera.from, camera.lookAt, camera.fovDegrees};
    for (const CameraKey& key : camera.keys) {
        if (!reached(key, time)) {
            const double s = std::max(time - before.at, 0.0) / (key.at - before.at);
            return mixed(before, key, eased(key.ease, s));
        }
        before = key;
    }
    return viewOf(before);
}

CameraView movedAt(const CameraDescription& camera, double time, double seconds) {
    CameraView view = viewAt(camera, time);
    const double part = std::clamp(time / std::max(seconds, kSameTime), 0.0, 1.0);
    const double share = eased(Ease::smooth, part);
    double degrees = camera.orbitDegreesPerSecond * time, nearer = 0.0;
    if (camera.move == CameraMove::orbit) degrees = kOrbitDegrees * (share - 0.5);
    if (camera.move == CameraMove::push) nearer = kPushShare * share;
    const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180.0, Vec3::UnitY());
    view.from = view.lookAt + (1.0 - nearer) * (turn * (view.from - view.lookAt));
    return view;
}

int shotAt(const CameraDescription& camera, double time) {
    const auto cut = [time](const CameraKey& k) { return k.ease == Ease::cut && reached(k, time); };
    return static_cast<int>(std::count_if(camera.keys.begin(), camera.keys.end(), cut));
}

std::optional<Vec3> placeOf(const Stage& stage, const std::string& body) {
    for (std::size_t i = 0; i < stage.bodies.size() && !body.empty(); ++i)
        if (stage.scene.bodies[i].name == body) return stage.world.pose(stage.bodies[i]).position;
    return std::nullopt;
}

render::Vec3 lightOf(const SceneDescription& scene) {
    if (scene.look.light) return scene.look.light->normalized().cast<float>();
    return keyLight(scene.camera.from, scene.camera.lookAt);
}

render::Camera cameraOf(const Moment& moment) {
    const CameraDescription& camera = moment.stage.scene.camera;
    const CameraView view = movedAt(camera, moment.time, moment.stage.scene.seconds);
    const Vec3 moved = followed(moment);
    const Vec3 from = view.from + moved, lookAt = view.lookAt + moved;
    render::Camera result;
    result.from = drawn(from);
    result.lookAt = drawn(lookAt);
    result.fovDegrees = static_cast<float>(view.fovDegrees);
    result.aperture = static_cast<float>(camera.aperture);
    result.focus = static_cast<float>(focusOf(moment.stage, from, lookAt));
    return result;
}

}  // namespace demos
