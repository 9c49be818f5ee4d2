// A player that continues from a saved state has the bits and the pictures of one that never stopped:
// all built-in scenes. With IMPULSE_LONG in the environment at three moments of the whole scene and
// with 1, 2 and 4 threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "demos/load/builtin.h"
#include "demos/load/load_scene.h"
#include "demos/snapshot/player.h"
#include "demos/watch/frame_hash.h"

namespace demos {
namespace {

std::vector<std::string> keptScenes() {
    std::vector<std::string> list;
    for (const BuiltinScene& scene : builtinScenes()) list.emplace_back(scene.name);
    return list;
}

/// Every overlay that has a memory.
Overlays remembering() {
    Overlays overlays;
    overlays.ghost = overlays.stats = overlays.nudges = overlays.impulses = overlays.friction =
        true;
    overlays.colorBy = "speed";
    overlays.ghostEvery = 0.05;
    return overlays;
}

std::uint64_t pictureOf(const Player& player) {
    return FrameHasher().of(player.frame(player.stage().world.report().time));
}

class KeepingOfScenes : public testing::TestWithParam<std::string> {};

void goOn(const std::string& scene, int before, int steps, int threads) {
    SceneDescription description = loadScene(scene);
    Player whole(description, remembering());
    whole.step(before);
    description.settings.threads = threads;
    Player rest(description, remembering());
    std::vector<std::uint8_t> state;
    whole.saveState(state);
    ASSERT_TRUE(rest.restoreState(state));
    EXPECT_EQ(pictureOf(rest), pictureOf(whole)) << "at once, step " << before;
    whole.step(steps), rest.step(steps);
    EXPECT_EQ(rest.stage().world.hash(), whole.stage().world.hash())
        << "step " << before << ", " << threads << " threads";
    EXPECT_EQ(pictureOf(rest), pictureOf(whole)) << "step " << before;
    EXPECT_EQ(rest.incident(), whole.incident());
}

TEST_P(KeepingOfScenes, GoesOnToTheSameBitsAndPictures) {
    goOn(GetParam(), 17, 8, 2);
    if (!std::getenv("IMPULSE_LONG")) return;
    const SceneDescription scene = loadScene(GetParam());
    const int steps = static_cast<int>(scene.seconds * scene.hz);
    for (const int threads : {1, 2, 4})
        for (const int part : {1, 2, 3})
            goOn(GetParam(), part * steps / 4, std::min(steps / 4, 120), threads);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, KeepingOfScenes, testing::ValuesIn(keptScenes()),
                         [](const testing::TestParamInfo<std::string>& tested) {
                             std::string name = tested.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace demos
