// The built-in scenes keep their own contracts.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "demos/load/builtin.h"
#include "demos/load/load_scene.h"
#include "demos/play/expect.h"

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

TEST_P(BuiltinScenes, KeepTheirContract) {
    Stage stage(loadScene(GetParam()));
    ExpectationChecker checker(stage);
    checker.look(stage);
    const int steps = static_cast<int>(stage.scene.seconds * stage.scene.hz + 0.5);
    for (int i = 0; i < steps; ++i) {
        ASSERT_TRUE(stage.step()) << "the world diverged at step " << i;
        checker.look(stage);
    }
    for (const ExpectationResult& result : checker.results())
        EXPECT_TRUE(result.passed) << result.text << ": " << result.value << " " << result.unit
                                   << " (" << result.why << ")";
}

TEST_P(BuiltinScenes, AreFitToBeShown) {
    const SceneDescription scene = loadScene(GetParam());
    EXPECT_FALSE(scene.title.empty());
    EXPECT_FALSE(scene.purpose.empty());
    EXPECT_LT(scene.purpose.size(), 80u);  // a line of the list
    EXPECT_EQ(std::count(kGroups.begin(), kGroups.end(), scene.group), 1) << scene.group;
    EXPECT_GE(scene.seconds, 5.0);
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
