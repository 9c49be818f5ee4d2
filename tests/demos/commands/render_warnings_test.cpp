// What impulse render tells of a run besides its film.
#include "tests/demos/program.h"

namespace demos::test {
namespace {

class RenderWarnings : public testing::Test {
protected:
    TemporaryFolder folder;
};

TEST_F(RenderWarnings, SaysThatAnExpectationFailedIfItPlaysTheWholeScene) {
    write(folder / "high.toml",
          kBall + "[[expect]]\nwhat = 'height'\nof = 'ball'\nabove = 1\nuntil = 1\n");
    const auto errorsWith = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"render", "high.toml", "--size",    "64x36",
                                              "--fps",  "10",        "--samples", "1"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ended ended = run(folder.path(), arguments);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return ended.err;
    };
    const std::string line = "warning: high: the expectation failed: least height of ball above 1 m, "
                             "0 s to 1 s: ";
    const std::string whole = errorsWith({});
    EXPECT_NE(whole.find(line), std::string::npos) << whole;
    EXPECT_NE(whole.find(" m ('ball' at "), std::string::npos) << whole;
    EXPECT_EQ(errorsWith({"--overwrite", "--frames", "0..8"}).find("expectation"), std::string::npos);
    EXPECT_EQ(errorsWith({"--overwrite", "--set", "world.gravity=[0, 0, 0]"}).find("expectation"),
              std::string::npos);
}

TEST_F(RenderWarnings, SaysThatABodyFallsOutOfTheScene) {
    write(folder / "lost.toml", "format = 1\nseconds = 4\n[[body]]\nname = 'lost'\n"
                                "shape = { sphere = 0.5 }\n");
    const Ended ended = run(folder.path(), {"render", "lost.toml", "--size", "640x360", "--fps", "5",
                                            "--samples", "1"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.err.find("warning: lost: 'lost' falls out of the scene: 78."), std::string::npos)
        << ended.err;
}

}  // namespace
}  // namespace demos::test
