// The n-th call of a function fails, for every n where that is cheap, and the last one: one line,
// the right code, nothing torn, nothing left beside, and the next run finishes the work.
// (failing_calls.cpp is preloaded.)
// Longer: IMPULSE_FAIL_ALL=1 cli_tests --gtest_filter='*FailingCalls*', with every n of every call.
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>

#include "tests/demos/program.h"

namespace demos::test {
namespace {

/// What a run does, and which of its calls fail.
struct Sweep {
    const char* name;
    std::vector<std::string> arguments;
    const char* call;
    int error;
    int every;  // n is a multiple of it; the first of the calls of malloc come before main()
};

class FailingCalls : public testing::TestWithParam<Sweep> {
protected:
    using Files = std::map<std::string, std::string>;

    FailingCalls() { renew(); }

    /// A folder with the scene alone.
    void renew() {
        fs::remove_all(place());
        fs::create_directories(place());
        write(place() / "ball.toml", kBall);
        write(folder_ / "count", std::string(4096, '\0'));
    }
    fs::path place() const { return folder_ / "place"; }

    Ended play(long failing) const {
        const Sweep& sweep = GetParam();
        Launch launch;
        launch.folder = place();
        launch.arguments = sweep.arguments;
        if (failing >= 0) {
            const std::string count = (folder_ / "count").string();
            launch.beforeExec = [failing, count, sweep] {
                setenv("LD_PRELOAD", IMPULSE_FAILING_CALLS, 1);
                setenv("IMPULSE_FAIL_CALL", sweep.call, 1);
                setenv("IMPULSE_FAIL_ERRNO", std::to_string(sweep.error).c_str(), 1);
                setenv("IMPULSE_FAIL_AT", std::to_string(failing).c_str(), 1);
                setenv("IMPULSE_FAIL_COUNT", count.c_str(), 1);
            };
        }
        return run(launch);
    }

    long calls() const {
        long count = 0;
        std::memcpy(&count, contentOf(folder_ / "count").data(), sizeof count);
        return count;
    }

    /// All files, by their names.
    Files results() const {
        Files files;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(place()))
            if (entry.is_regular_file())
                files[fs::relative(entry.path(), place()).string()] = contentOf(entry.path());
        return files;
    }

    TemporaryFolder folder_;
};

TEST_P(FailingCalls, TearNothingAndTheNextRunFinishes) {
    const Sweep& sweep = GetParam();
    ASSERT_EQ(play(0).code, 0);
    const long count = calls();
    ASSERT_GT(count, 0) << "the library counts no " << sweep.call;
    const Files good = results();
    const int every = std::getenv("IMPULSE_FAIL_ALL") ? 1 : sweep.every;
    for (long at = every; at < count + every; at += every) {
        const long n = std::min(at, count);
        SCOPED_TRACE(std::string(sweep.call) + " " + std::to_string(n));
        renew();
        const Ended ended = play(n);
        EXPECT_EQ(ended.signal, 0);
        if (ended.code != 0) {
            EXPECT_EQ(ended.code, 4) << ended.err;
            EXPECT_EQ(ended.errorLines(), 1) << ended.err;
            EXPECT_EQ(ended.err.rfind("impulse: ", 0), 0u) << ended.err;
            for (const auto& [name, content] : results())
                EXPECT_TRUE(good.contains(name)) << name << " was left";
            EXPECT_EQ(play(-1).code, 0);
        }
        EXPECT_EQ(results(), good);
    }
}

const std::vector<std::string> kExport{"export", "ball.toml", "-o",     "a.html",
                                       "-o",     "a.glb",     "--quiet"};
const std::vector<std::string> kSim{"sim", "ball.toml", "--csv", "a.csv", "--quiet"};
const std::vector<std::string> kRender{"render", "ball.toml", "-o",     "film", "--size", "64x36",
                                       "--fps",  "2",         "--jobs", "1",    "--quiet"};
const std::vector<std::string> kSlides{"slides", "ball.toml", "-o", "deck/", "--size", "64x64",
                                       "--fps",  "2",         "-j", "1",     "--quiet"};
const std::vector<std::string> kPasses = [] {
    std::vector<std::string> arguments = kRender;
    arguments.insert(arguments.end(), {"--pass", "poses"});
    return arguments;
}();

INSTANTIATE_TEST_SUITE_P(
    Commands, FailingCalls,
    testing::Values(Sweep{"export_write", kExport, "write", ENOSPC, 1},
                    Sweep{"export_renameat2", kExport, "renameat2", EIO, 1},
                    Sweep{"export_flock", kExport, "flock", EIO, 1},
                    Sweep{"sim_rename", kSim, "rename", EIO, 1},
                    Sweep{"sim_malloc", kSim, "malloc", ENOMEM, 4001},
                    Sweep{"slides_rename", kSlides, "rename", EIO, 12},
                    Sweep{"passes_rename", kPasses, "rename", EIO, 2},
                    Sweep{"render_send", kRender, "send", EPIPE, 3}),
    [](const auto& sweep) { return std::string(sweep.param.name); });

}  // namespace
}  // namespace demos::test
