// [camera] and its keys

#include <algorithm>
#include <cmath>

#include "demos/scene/ranges.h"
#include "demos/scene/table_readers.h"
#include "demos/text/nearest.h"

namespace demos {
namespace {

constexpr double kLagOfAll = 0.5;  // s, of a camera that follows all bodies
constexpr Range kFieldOfView{1.0, 170.0, "deg"};

/// m: the horizontal length of the line of sight. A camera that looks along y has no "up".
double aside(const Vec3& sight) { return std::hypot(sight.x(), sight.z()); }

bool isUpright(const Vec3& sight) { return aside(sight) < 1e-4 * sight.norm(); }

void checkView(Keys& keys, const Vec3& sight) {
    if (sight.norm() < 1e-3)
        keys.complain("from", "from and look_at are the same point; move one of them");
    else if (isUpright(sight))
        keys.complain("from", "the camera looks straight up or down; move it a little aside");
}

/// Between the keys the line of sight is a + s (b - a), 0 <= s <= 1. The limit of isUpright applies
/// there too.
void checkWay(Keys& keys, const Vec3& a, const Vec3& b) {
    if (isUpright(a) || isUpright(b)) return;  // reported already
    const Vec3 way(b.x() - a.x(), 0.0, b.z() - a.z());
    const double length = way.squaredNorm();
    const double s = length > 0.0 ? std::clamp(-way.dot(a) / length, 0.0, 1.0) : 0.0;
    if (isUpright(a + s * (b - a)))
        keys.complain("at",
                      "on the way to this key the camera passes straight above, below or through "
                      "the point that it looks at; lead it around with a key in between");
}

Ease readEase(Keys& keys) {
    static const std::vector<std::string> words{"smooth", "linear", "in", "out", "cut"};
    const std::string word = keys.word("ease", words).value_or(words.front());
    return static_cast<Ease>(std::find(words.begin(), words.end(), word) - words.begin());
}

void readTime(Keys& keys, double seconds, CameraKey& key, bool first) {
    if (!keys.has("at")) keys.complain("at", "a key of the camera has no time; write at = 2.0 (s)");
    const std::optional<double> at = keys.number("at", {0.0, seconds, "s"});
    if (at && !first && *at <= key.at)
        keys.complain("at", "at is " + numberText(*at) +
                                " s; it should be later than the key "
                                "before, which is at " +
                                numberText(key.at) + " s");
    set(key.at, at);
}

CameraKey readKey(const Value& table, Keys keys, const CameraKey& before, bool first,
                  double seconds) {
    if (table.kind != Value::Kind::table) return before;
    CameraKey key = before;
    readTime(keys, seconds, key, first);
    key.ease = readEase(keys);
    set(key.from, keys.vector("from", kMeters));
    set(key.lookAt, keys.vector("look_at", kMeters));
    set(key.fovDegrees, keys.number("fov_deg", kFieldOfView));
    keys.done();
    const Vec3 sight = key.lookAt - key.from, was = before.lookAt - before.from;
    if (keys.has("from") || keys.has("look_at")) checkView(keys, sight);
    if (key.ease != Ease::cut && key.at > before.at) checkWay(keys, was, sight);
    return key;
}

void readKeys(Keys& keys, SceneDescription& scene) {
    CameraDescription& camera = scene.camera;
    CameraKey last{0.0, camera.from, camera.lookAt, camera.fovDegrees};
    for (const Value* table : keys.tables("keys")) {
        last = readKey(*table, keys.inner(*table, "a key of the camera"), last, camera.keys.empty(),
                       scene.seconds);
        camera.keys.push_back(last);
    }
}

/// Reports an error if `name` is not that of a body.
void checkBody(Keys& keys, const char* key, const std::string& name, const BodyNumbers& numbers,
               const SceneDescription& scene) {
    if (!name.empty() && !numbers.contains(name))
        keys.complain(key, "no body is called '" + name + "'" + suggestion(name, bodyNames(scene)));
}

/// A move replaces the other ways to move the camera.
void readMove(Keys& keys, CameraDescription& camera) {
    static const std::vector<std::string> words{"none", "push", "orbit", "follow"};
    const std::string word = keys.word("move", words).value_or(words.front());
    camera.move =
        static_cast<CameraMove>(std::find(words.begin(), words.end(), word) - words.begin());
    if (camera.move == CameraMove::follow && !keys.has("follow_lag"))
        camera.followLag = kLagOfAll;
    if (camera.move == CameraMove::none) return;
    for (const char* key : {"keys", "orbit_deg_per_s", "follow"})
        if (keys.has(key))
            keys.complain("move", "move = \"" + word + "\" and " + key +
                                      " both move the camera; leave one of them out");
}

void readLens(Keys& keys, const BodyNumbers& numbers, SceneDescription& scene) {
    CameraDescription& camera = scene.camera;
    set(camera.aperture, keys.number("aperture", {0.0, 10.0, "m"}));
    const Value* focus = keys.any("focus");
    if (focus && focus->kind == Value::Kind::text) {
        set(camera.focusBody, keys.text("focus"));
        checkBody(keys, "focus", camera.focusBody, numbers, scene);
    } else if (focus && focus->isNumber()) {
        set(camera.focus, keys.number("focus", {0.01, 1e5, "m"}));
    } else if (focus) {
        keys.complain("focus", "focus is " + describe(*focus) +
                                   "; it should be a body's name or a distance in m");
    }
}

}  // namespace

void readCamera(Keys& top, const BodyNumbers& numbers, SceneDescription& scene) {
    const Value* table = top.any("camera");
    if (!table) return;
    Keys keys = top.inner(*table, "[camera]");
    CameraDescription& camera = scene.camera;
    set(camera.from, keys.vector("from", kMeters));
    set(camera.lookAt, keys.vector("look_at", kMeters));
    for (const char* key : {"from", "look_at", "keys", "follow"})
        if (keys.has(key)) camera.fitsMotion = false;
    set(camera.fovDegrees, keys.number("fov_deg", kFieldOfView));
    set(camera.orbitDegreesPerSecond, keys.number("orbit_deg_per_s", {-3600.0, 3600.0, "deg/s"}));
    set(camera.follow, keys.text("follow"));
    checkBody(keys, "follow", camera.follow, numbers, scene);
    set(camera.followLag, keys.number("follow_lag", {0.0, 100.0, "s"}));
    readMove(keys, camera);
    if (keys.has("follow_lag") && !keys.has("follow") && camera.move != CameraMove::follow)
        keys.complain("follow_lag", "follow_lag needs something to follow; write follow = \"NAME\" "
                                    "or move = \"follow\"");
    checkView(keys, camera.lookAt - camera.from);
    readLens(keys, numbers, scene);
    readKeys(keys, scene);
    keys.done();
}

}  // namespace demos
