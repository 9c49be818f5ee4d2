// The built-in scenes meet their own expectations.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "demos/load/builtin.h"
#include "demos/load/load_scene.h"
#include "demos/play/expect.h"
#include "demos/play/falls.h"

namespace demos {
namespace {

std::vector<std::string> names() {
    std::vector<std::string> list;
    for (const BuiltinScene& scene : builtinScenes()) list.emplace_back(scene.name);
    return list;
}

const std::vector<std::string> kGroups = {
    "stacks", "chains and pendulums", "machines", "friction and restitution",
    "forces", "solver",               "many bodies"};

class BuiltinScenes : public testing::TestWithParam<std::string> {};

/// Scenes that take more than half a second at 240 Hz: tested with IMPULSE_LONG only.
const std::set<std::string> kHeavy = {"ball-pit",      "galton",  "hanging-cloth", "jenga",
                                      "look-at",       "ragdoll", "rope-bridge",   "safety-net",
                                      "shapes",        "tumbler", "trampoline",    "wall",
                                      "wrecking-ball", "car"};

/// The expectations that fail; `hz` 0: at the scene's own rate.
std::string failures(const std::string& scene, int hz) {
    std::vector<std::string> overrides;
    if (hz != 0) overrides.push_back("world.hz=" + std::to_string(hz));
    Stage stage(loadScene(scene, overrides));
    ExpectationChecker checker(stage);
    checker.look(stage);
    Falls falls;
    const int steps = static_cast<int>(stage.scene.seconds * stage.scene.hz + 0.5);
    for (int i = 0; i < steps; ++i) {
        if (!stage.step()) return "the world diverged at step " + std::to_string(i);
        checker.look(stage);
        falls.look(stage);
    }
    std::string text = falls.line(stage);
    for (const ExpectationResult& result : checker.results())
        if (!result.passed)
            text += result.text + ": " + cameOut(result) + " (" + result.why + ")\n";
    return text;
}

TEST_P(BuiltinScenes, KeepTheirContract) { EXPECT_EQ(failures(GetParam(), 0), ""); }

/// s at the end in which no body is seen to move.
double stillAtTheEnd(const std::string& scene) {
    Stage stage(loadScene(scene));
    const auto places = [&stage] {
        std::vector<Vec3> all;
        for (const engine::BodyId id : stage.bodies)
            all.push_back(stage.world.pose(id).position);
        return all;
    };
    const auto isSeen = [&stage](const Vec3& moved, engine::BodyId id) {
        constexpr double kSeen = 0.01, kSeenTurn = 0.05;  // m/s, rad/s
        return moved.norm() > kSeen * stage.dt() ||
               (stage.world.has(id) && stage.world.spin(id).norm() > kSeenTurn);
    };
    std::vector<Vec3> before = places();
    int still = 0;
    const int steps = static_cast<int>(stage.scene.seconds * stage.scene.hz + 0.5);
    for (int i = 0; i < steps && stage.step(); ++i) {
        ++still;
        const std::vector<Vec3> now = places();
        for (std::size_t k = 0; k < now.size(); ++k)
            if (isSeen(now[k] - before[k], stage.bodies[k])) still = 0;
        before = now;
    }
    return still * stage.dt();
}

TEST_P(BuiltinScenes, HaveNoDeadTimeAtTheEnd) {
    if (loadScene(GetParam()).camera.move != CameraMove::none) return;  // then the camera moves
    EXPECT_LE(stillAtTheEnd(GetParam()), 2.0);
}

TEST_P(BuiltinScenes, KeepItAtSixtyAndTwoHundredAndFortyHertz) {
    const int own = loadScene(GetParam()).hz;
    for (const int hz : {60, 240}) {
        if (hz == own) continue;
        if (hz == 240 && kHeavy.contains(GetParam()) && !std::getenv("IMPULSE_LONG")) continue;
        EXPECT_EQ(failures(GetParam(), hz), "") << "at " << hz << " Hz";
    }
}

TEST_P(BuiltinScenes, AreFitToBeShown) {
    const SceneDescription scene = loadScene(GetParam());
    EXPECT_FALSE(scene.title.empty());
    EXPECT_FALSE(scene.purpose.empty());
    EXPECT_LT(scene.purpose.size(), 80u);  // a line of the list
    EXPECT_EQ(std::count(kGroups.begin(), kGroups.end(), scene.group), 1) << scene.group;
    EXPECT_GE(scene.seconds, 2.0);
    EXPECT_LE(scene.seconds, 10.0);
    EXPECT_FALSE(scene.sections.empty());
    EXPECT_GE(scene.expectations.size(), 2u);
    for (const Expectation& e : scene.expectations) EXPECT_FALSE(e.why.empty());
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinScenes, testing::ValuesIn(names()),
                         [](const testing::TestParamInfo<std::string>& scene) {
                             std::string name = scene.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(BuiltinSceneList, IsSortedAndComplete) {
    const std::vector<std::string> list = names();
    EXPECT_TRUE(std::is_sorted(list.begin(), list.end()));
    EXPECT_GE(list.size(), 34u);
}

TEST(BuiltinSceneList, HasSomethingOfEveryGroup) {
    std::set<std::string> groups, purposes;
    for (const std::string& name : names()) {
        const SceneDescription scene = loadScene(name);
        groups.insert(scene.group);
        EXPECT_TRUE(purposes.insert(scene.purpose).second) << name << ": " << scene.purpose;
    }
    EXPECT_EQ(groups, std::set<std::string>(kGroups.begin(), kGroups.end()));
}

}  // namespace
}  // namespace demos
