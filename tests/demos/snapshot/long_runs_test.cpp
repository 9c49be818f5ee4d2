// Built-in scenes for ten minutes of simulated time, twice: the same bits each minute, and no memory that grows.
// With IMPULSE_LONG in the environment all of them; otherwise a few for some seconds.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "demos/load/builtin.h"
#include "demos/load/load_scene.h"
#include "demos/snapshot/player.h"

namespace demos {
namespace {

constexpr int kParts = 10;
constexpr std::size_t kGrowth = 64 << 10;  // bytes: a vector of a small scene that takes its next size

bool isLong() { return std::getenv("IMPULSE_LONG") != nullptr; }

std::vector<std::string> playedScenes() {
    if (!isLong()) return {"pendulum", "galton", "restitution-row"};
    std::vector<std::string> list;
    for (const BuiltinScene& scene : builtinScenes()) list.emplace_back(scene.name);
    return list;
}

/// Bytes that are allocated now.
std::size_t allocated() {
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

struct LongRun {
    std::vector<std::uint64_t> hashes;   // of the world, after each part
    std::vector<std::size_t> memory;
};

LongRun play(const SceneDescription& scene) {
    LongRun run;
    run.hashes.reserve(kParts), run.memory.reserve(kParts);
    Player player(scene, {});
    const double seconds = isLong() ? 60.0 : 0.5;
    for (int part = 0; part < kParts; ++part) {
        player.step(static_cast<int>(seconds * scene.hz));
        run.hashes.push_back(player.stage().world.hash());
        run.memory.push_back(allocated());
    }
    return run;
}

class LongRuns : public testing::TestWithParam<std::string> {};

TEST_P(LongRuns, HaveTheSameBitsAndKeepTheirMemory) {
    const SceneDescription scene = loadScene(GetParam());
    const LongRun first = play(scene), again = play(scene);
    EXPECT_EQ(first.hashes, again.hashes);
    const std::size_t half = *std::max_element(first.memory.begin(), first.memory.begin() + kParts / 2);
    EXPECT_LE(first.memory.back(), half + half / 100 + kGrowth);
}

std::string nameOfScene(const testing::TestParamInfo<std::string>& tested) {
    std::string name = tested.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, LongRuns, testing::ValuesIn(playedScenes()), nameOfScene);

}  // namespace
}  // namespace demos
