// Films of which only what changed is drawn, compared byte by byte with whole frames. All scenes:
// tests/benchmark/README.md.
#include <gtest/gtest.h>

#include "tests/demos/program.h"

namespace demos::test {
namespace {

constexpr std::size_t kFrameBytes = 4 * 192 * 108;

/// The raw pixels of half a second.
std::string filmOf(const std::string& scene, const std::vector<std::string>& more) {
    Launch launch;
    const TemporaryFolder folder;
    launch.folder = folder.path();
    launch.arguments = {"render", scene, "--size", "192x108", "--seconds", "0.5",
                        "-o",     "-",   "--quiet"};
    launch.arguments.insert(launch.arguments.end(), more.begin(), more.end());
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.out;
}

void expectSameBothWays(const std::string& scene, std::vector<std::string> look) {
    const std::string kept = filmOf(scene, look);
    look.push_back("--whole-frames");
    const std::string whole = filmOf(scene, look);
    ASSERT_EQ(kept.size(), 15 * kFrameBytes);
    ASSERT_EQ(whole.size(), kept.size());
    for (std::size_t i = 0; i < kept.size(); i += kFrameBytes)
        EXPECT_TRUE(kept.compare(i, kFrameBytes, whole, i, kFrameBytes) == 0)
            << scene << ", frame " << i / kFrameBytes;
}

TEST(WholeFrames, HaveTheBytesOfFramesOfWhichOnlyWhatChangedIsDrawn) {
    expectSameBothWays("wall", {"-j", "1"});
    expectSameBothWays("galton", {"-j", "2", "--theme", "transparent"});
    expectSameBothWays("safety-net", {"-j", "1", "--theme", "dark", "--show",
                                      "contacts,trails,ghost,bounds,joints,ids"});
}

TEST(WholeFrames, AreNotNeededForAFrameThatIsDrawnAlone) {
    const std::string film = filmOf("stack", {"-j", "1"});
    const std::string alone = filmOf("stack", {"-j", "1", "--frames", "9"});
    ASSERT_EQ(alone.size(), kFrameBytes);
    EXPECT_TRUE(film.compare(9 * kFrameBytes, kFrameBytes, alone) == 0);
}

}  // namespace
}  // namespace demos::test
