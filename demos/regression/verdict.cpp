#include "demos/regression/verdict.h"

#include <algorithm>

#include "demos/text/complaints.h"

namespace demos {

bool SceneVerdict::keepsContract() const {
    return std::all_of(expectations.begin(), expectations.end(),
                       [](const ExpectationResult& result) { return result.passed; });
}

bool SceneVerdict::isAsItWas() const {
    return physics.kind == PhysicsVerdict::Kind::same && changedScene().empty() &&
           std::all_of(pictures.begin(), pictures.end(), [](const PictureVerdict& picture) {
               return picture.kind == PictureVerdict::Kind::same;
           });
}

std::vector<SettingChange> SceneVerdict::changedScene() const {
    std::vector<SettingChange> changes = settings;
    std::erase_if(changes, [](const SettingChange& change) {
        return change.key == "impulse" || change.key == "renderer" || change.key == "pixels" ||
               change.key == "samples";
    });
    return changes;
}

bool SceneVerdict::onlyAddsPictures() const {
    return problem.empty() && physics.passes() &&
           std::all_of(pictures.begin(), pictures.end(), [](const PictureVerdict& picture) {
               return picture.passes() || picture.kind == PictureVerdict::Kind::added;
           });
}

int TestVerdict::count(SceneVerdict::State state) const {
    return static_cast<int>(
        std::count_if(scenes.begin(), scenes.end(),
                      [state](const SceneVerdict& scene) { return scene.state == state; }));
}

bool TestVerdict::passed() const {
    return count(SceneVerdict::State::failed) + count(SceneVerdict::State::error) == 0;
}

const char* nameOf(SceneVerdict::State state) {
    switch (state) {
        case SceneVerdict::State::passed:
            return "passed";
        case SceneVerdict::State::failed:
            return "failed";
        case SceneVerdict::State::added:
            return "new";
        case SceneVerdict::State::updated:
            return "updated";
        case SceneVerdict::State::error:
            break;
    }
    return "error";
}

const char* nameOf(PictureVerdict::Kind kind) {
    switch (kind) {
        case PictureVerdict::Kind::same:
            return "same";
        case PictureVerdict::Kind::within:
            return "within";
        case PictureVerdict::Kind::changed:
            return "changed";
        case PictureVerdict::Kind::added:
            return "new";
        case PictureVerdict::Kind::broken:
            break;
    }
    return "broken";
}

const char* nameOf(PhysicsVerdict::Kind kind) {
    switch (kind) {
        case PhysicsVerdict::Kind::unknown:
            return "unknown";
        case PhysicsVerdict::Kind::same:
            return "same";
        case PhysicsVerdict::Kind::bits:
            return "bits";
        case PhysicsVerdict::Kind::changed:
            break;
    }
    return "changed";
}

std::string pictureName(const std::string& scene, double time) {
    return scene + "@" + numberText(time);
}

}  // namespace demos
