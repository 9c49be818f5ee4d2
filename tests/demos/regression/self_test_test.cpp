// Tests gate and tolerances with mutants of real scenes: all are drawn and caught.
#include <gtest/gtest.h>

#include "demos/load/load_scene.h"
#include "demos/regression/mutants.h"
#include "tests/demos/reading.h"

namespace demos {
namespace {

Options optionsFor(const std::string& scene) {
    Options options;
    options.anyStep = true;
    options.scenes = {scene};
    return options;
}

std::vector<MutantSummary> tested(const SceneDescription& scene) {
    Options options = optionsFor(scene.name);
    options.size = PictureSize{scene.snapshot.width, scene.snapshot.height};
    const FilmPlan plan = planFilm({Panel{scene, {}, {}}}, false, options);
    render::Renderer renderer(plan.picture);
    return summaries(selfTest(plan, renderer));
}

/// A gate and tolerances that notice nothing.
const std::vector<std::string> kLax = {
    "snapshot.gate={levels=255,window=256,ssim=-1,why='to miss'}",
    "snapshot.tolerance={position=1e5,angle_deg=180,load=1e9,why='to miss'}"};

struct Scenario {
    const char* scene;
    double time;  // s, when things move
};

class SelfTest : public testing::TestWithParam<Scenario> {};

TEST_P(SelfTest, CatchesEveryMutant) {
    SceneDescription scene = loadScene(GetParam().scene);
    scene.snapshot.times = {GetParam().time};
    for (const MutantSummary& mutant : tested(scene)) {
        const std::string name = mutant.mutant->name;
        EXPECT_TRUE(mutant.caught())
            << name << ": window " << mutant.window << ", SSIM " << mutant.ssim;
        EXPECT_FALSE(mutant.unchanged) << name;
        const bool ofRun = name == "mass x2" || name == "gravity";
        const bool ofState = name == "1 mm" || name == "1 cm" || name == "late" || ofRun;
        EXPECT_EQ(mutant.state, ofState ? 1 : 0) << name;
        // The smallest damage may be smaller than a pixel: then the state notices it.
        EXPECT_TRUE(mutant.picture == 1 || name == "1 mm" || ofRun) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SelfTest,
                         testing::Values(Scenario{"stack", 3.2}, Scenario{"pendulum", 1.0},
                                         Scenario{"wall", 1.5}, Scenario{"friction-ramp", 1.0}),
                         [](const testing::TestParamInfo<Scenario>& scenario) {
                             std::string name = scenario.param.scene;
                             std::erase(name, '-');
                             return name;
                         });

TEST(SelfTestOf, ALaxGateMissesEveryMutant) {
    SceneDescription scene = loadScene("stack", kLax);
    scene.snapshot.times = {3.2};
    for (const MutantSummary& mutant : tested(scene))
        EXPECT_TRUE(mutant.missed()) << mutant.mutant->name;
}

TEST(SelfTestOf, ASceneWhereNothingMovesHasLessToCatch) {
    SceneDescription scene = test::read(
        test::kFloor + "[[body]]\nname = 'box'\nshape = { box = [1, 1, 1] }\nat = [0, 0.5, 0]\n" +
        "fixed = true\n[snapshot]\ntimes = [0]\n");
    for (const MutantSummary& mutant : tested(scene)) {
        const std::string name = mutant.mutant->name;
        const bool ofPicture = name == "light" || name == "no shadow" || name == "gamma";
        EXPECT_EQ(mutant.caught(), ofPicture) << name;
        EXPECT_EQ(mutant.unchanged, !ofPicture) << name;
        EXPECT_FALSE(mutant.missed()) << name;
    }
}

TEST(SelfTestOf, WhatIsAtRestIsTheSameOneStepLater) {
    SceneDescription scene = test::read(
        test::kFloor + "[[body]]\nname = 'box'\nshape = { box = [1, 1, 1] }\nat = [0, 0.5, 0]\n" +
        "[snapshot]\ntimes = [0.2]\n");
    for (const MutantSummary& mutant : tested(scene)) {
        EXPECT_EQ(mutant.unchanged, std::string(mutant.mutant->name) == "late") << mutant.mutant->name;
        EXPECT_FALSE(mutant.missed()) << mutant.mutant->name;
    }
}

TEST(SelfTestOf, TwoTimesOfOneStepAreOne) {
    SceneDescription scene = test::read(test::kFloor + test::kBall);
    scene.snapshot.times = {0.1, 0.1001, 0.2};
    for (const MutantSummary& mutant : tested(scene)) EXPECT_EQ(mutant.times, 2);
}

}  // namespace
}  // namespace demos
