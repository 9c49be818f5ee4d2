// impulse sim --states, and what continues from them: sim, still and bench --from, render --states.
#include <gtest/gtest.h>

#include "tests/demos/program.h"
#include "tests/demos/small_film.h"

namespace demos::test {
namespace {

/// A scene whose pictures need all steps before: trails, a lagging camera, statistics, ghosts,
/// arrows to scale.
constexpr const char* kRemembering = R"(format = 1
seconds = 1
[look]
show = ["stats", "ghost", "impulses"]
trails = ["ball"]
[camera]
from = [0, 2, 9]
look_at = [0, 1, 0]
follow = "ball"
follow_lag = 0.4
[[material]]
name = "rubber"
restitution = 0.6
[[body]]
name = "floor"
shape = { plane = [0, 1, 0] }
fixed = true
[[body]]
name = "ball"
shape = { sphere = 0.4 }
at = [0, 1.2, 0]
velocity = [1.5, 0, 0]
material = "rubber"
)";

class States : public testing::Test {
protected:
    void SetUp() override {
        write(folder_ / "ball.toml", kRemembering);
        const Ended wrote =
            run("sim", {"--states", "states", "--every", "10", "--hash", "--quiet"});
        ASSERT_EQ(wrote.code, 0) << wrote.err;
        whole_ = wrote.out;
    }
    Ended run(const std::string& command, std::vector<std::string> more) const {
        more.insert(more.begin(), {command, "ball.toml"});
        return test::run(folder_.path(), more);
    }
    TemporaryFolder folder_;
    std::string whole_;
};

TEST_F(States, GoOnToTheSameBits) {
    EXPECT_TRUE(fs::exists(folder_ / "states/000010.state"));
    EXPECT_FALSE(fs::exists(folder_ / "states/000015.state"));
    const Ended rest = run("sim", {"--from", "states/000030.state", "--hash", "--quiet"});
    EXPECT_EQ(rest.code, 0) << rest.err;
    EXPECT_EQ(rest.out, whole_);
    const std::string from = "states/000040.state";
    const Ended bench = run("bench", {"--from", from, "--json"});
    EXPECT_EQ(bench.code, 0) << bench.err;
    const std::string hash = whole_.substr(whole_.rfind(' ') + 1, 16);
    EXPECT_NE(bench.out.find(hash), std::string::npos) << bench.out << whole_;
    const Ended one = run("still", {"-t", "0.9", "-o", "one.png", "--size", "160x90"});
    const Ended two =
        run("still", {"-t", "0.9", "-o", "two.png", "--size", "160x90", "--from", from});
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_EQ(two.code, 0) << two.err;
    EXPECT_EQ(contentOf(folder_ / "one.png"), contentOf(folder_ / "two.png"));
}

TEST_F(States, ShardsStartFromTheNearest) {
    const auto render = [&](std::vector<std::string> more) {
        more.insert(more.end(), {"--size", "160x90", "--fps", "15", "-j", "1", "--quiet"});
        const Ended ended = run("render", more);
        EXPECT_EQ(ended.code, 0) << ended.err;
    };
    render({"-o", "whole"});
    // A state that is not whole is passed over, and the one before it is taken.
    const std::string torn = contentOf(folder_ / "states/000040.state").substr(0, 300);
    write(folder_ / "states/000040.state", torn);
    render({"-o", "part", "--shard", "3/3", "--states", "states"});
    render({"-o", "blurred", "--blur", "4"});
    render({"-o", "part-blurred", "--blur", "4", "--shard", "3/3", "--states", "states"});
    for (const char* frame : {"frame_000010.png", "frame_000012.png", "frame_000014.png"}) {
        EXPECT_EQ(contentOf(folder_ / "whole" / frame), contentOf(folder_ / "part" / frame));
        EXPECT_EQ(contentOf(folder_ / "blurred" / frame),
                  contentOf(folder_ / "part-blurred" / frame));
    }
}

/// A camera that fits the motion of the whole run.
TEST_F(States, HaveTheCameraOfTheWholeRun) {
    EXPECT_FALSE(fs::exists(folder_ / "states/camera.state"));
    std::string scene = kRemembering;
    scene.erase(scene.find("[camera]"), scene.find("[[material]]") - scene.find("[camera]"));
    write(folder_ / "ball.toml", scene);
    ASSERT_EQ(run("sim", {"--states", "states", "--every", "10", "--quiet"}).code, 0);
    EXPECT_TRUE(fs::exists(folder_ / "states/camera.state"));
    const auto areTheSame = [&](const std::string& seconds) {
        std::vector<std::string> words = {"--seconds", seconds, "--shard", "2/2", "--size", "160x90",
                                          "--fps", "15", "-o", "alone" + seconds.substr(0, 1)};
        EXPECT_EQ(run("render", words).code, 0);
        words.back() = "from" + seconds.substr(0, 1);
        words.insert(words.end(), {"--states", "states"});
        EXPECT_EQ(run("render", words).code, 0);
        return framesIn(folder_ / ("alone" + seconds.substr(0, 1))) ==
               framesIn(folder_ / ("from" + seconds.substr(0, 1)));
    };
    EXPECT_TRUE(areTheSame("1"));
    EXPECT_TRUE(areTheSame("0.5")) << "of another length";
    const std::vector<std::string> still = {"-t", "0.9", "--size", "160x90", "-o", "-"};
    std::vector<std::string> from = still;
    from.insert(from.end(), {"--from", "states/000040.state"});
    EXPECT_TRUE(run("still", from).out == run("still", still).out);
}

TEST_F(States, AreRefusedWhereTheyDoNotBelong) {
    const std::string state = "states/000030.state";
    const auto refuses = [&](const Ended& ended, int code, const std::string& why) {
        EXPECT_EQ(ended.code, code);
        EXPECT_EQ(ended.errorLines(), 1);
        EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
    };
    refuses(test::run(folder_.path(), {"sim", "stack", "--from", state}), 2,
            "is a state of the scene 'ball', and not of 'stack'");
    refuses(run("sim", {"--set", "world.gravity=[0,-1,0]", "--from", state}), 2,
            "is a state of 'ball' with other values");
    refuses(run("still", {"-t", "0.1", "--from", state}), 2, "an earlier state is needed");
    refuses(run("still", {"--show", "nudges", "--from", state}), 2, "--show nudges");
    refuses(run("sim", {"--from", "none.state"}), 4, "none.state");
    refuses(run("bench", {"--film", "--from", state}), 2, "without --film");
    std::string bytes = contentOf(folder_ / state);
    for (const std::size_t at : {bytes.size() / 3, bytes.size() - 1, std::size_t{20}}) {
        std::string changed = bytes;
        changed[at] = static_cast<char>(changed[at] ^ 4);
        write(folder_ / "changed.state", changed);
        refuses(run("sim", {"--from", "changed.state"}), 4, "truncated or damaged");
    }
    write(folder_ / "text.state", "not a state at all, but a text");
    refuses(run("sim", {"--from", "text.state"}), 4, "is no state");
}

}  // namespace
}  // namespace demos::test
