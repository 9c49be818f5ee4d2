/// A film's memory: it does not grow with the film's length, and is predicted before drawing.
#include "tests/demos/small_film.h"

namespace demos::test {
namespace {

class Memory : public SmallFilm {};

// ru_maxrss: the largest of the program and its drawing processes.
TEST_F(Memory, DoesNotGrowWithTheFilm) {
    const std::vector<std::vector<std::string>> kinds = {{"-o", "frames"}, {"-o", "-"}};
    for (const std::vector<std::string>& kind : kinds) {
        long peak[2] = {};
        for (const int longer : {0, 1}) {
            std::vector<std::string> more = kind;
            more.insert(more.end(), {"--overwrite", "--seconds", longer ? "40" : "4"});
            const Ended ended = film(more);
            ASSERT_EQ(ended.code, 0) << ended.err;
            peak[longer] = ended.peakKiB;
        }
        EXPECT_GT(peak[0], 20 * 1024);
        // 360 more frames are 7 MiB of pixels in each process; the noise is well below one.
        EXPECT_LT(peak[1] - peak[0], 3 * 1024) << kind[1];
    }
}

/// The letter of a process's state: 'S' when it waits.
char stateOf(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string text;
    std::getline(file, text);
    const std::size_t at = text.rfind(") ");
    return at == std::string::npos ? '?' : text[at + 2];
}

std::vector<pid_t> familyOf(pid_t parent) {
    std::vector<pid_t> all{parent};
    const std::string name = std::to_string(parent);
    std::ifstream children("/proc/" + name + "/task/" + name + "/children");
    for (pid_t child = 0; children >> child;) all.push_back(child);
    return all;
}

long residentKiB(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("VmRSS:")) return std::atol(line.c_str() + 6);
    return 0;
}

// Standard output is not read until all processes wait. 400 frames are 8 MB; between drawing and
// pipe there is room for a few.
TEST_F(Memory, WhereNothingIsTakenNothingMoreIsDrawn) {
    int out[2];
    ASSERT_EQ(pipe2(out, O_CLOEXEC), 0);
    const int silent = open("/dev/null", O_WRONLY | O_CLOEXEC);
    const Launch launch = small(folder.path(), {"-o", "-", "--seconds", "40", "--jobs", "2"});
    const pid_t child = fork();
    if (child == 0) becomeProgram(launch, out[1], silent);
    close(out[1]);
    close(silent);
    std::string taken(4 * kWidth * kHeight, '\0');  // the first frame: the workers are at work
    for (std::size_t at = 0; at < taken.size();) {
        const ssize_t got = read(out[0], taken.data() + at, taken.size() - at);
        ASSERT_GT(got, 0);
        at += static_cast<std::size_t>(got);
    }
    const auto allWait = [child] {
        for (const pid_t process : familyOf(child))
            if (stateOf(process) != 'S') return false;
        return true;
    };
    for (int calm = 0; calm < 1000; calm = allWait() ? calm + 1 : 0) sched_yield();
    for (const pid_t process : familyOf(child)) EXPECT_LT(residentKiB(process), 120 * 1024);
    std::size_t rest = 0;
    std::vector<char> block(1 << 16);
    for (ssize_t got; (got = read(out[0], block.data(), block.size())) > 0;)
        rest += static_cast<std::size_t>(got);
    close(out[0]);
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    EXPECT_EQ(rest, 399 * taken.size());
    const Ended quick = film({"-o", "-", "--seconds", "4"});
    EXPECT_LT(used.ru_maxrss - quick.peakKiB, 3 * 1024);
}

TEST_F(Memory, ADryRunTellsAndDrawsNothing) {
    const Ended ended = film({"--dry-run", "--jobs", "2"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    for (const char* part :
         {"10 frames of 96x54", "memory: 2 drawing processes of ",
          "output: output/ball/frame_000000.png ..., about ", "nothing was drawn"})
        EXPECT_NE(ended.out.find(part), std::string::npos) << part << " in\n" << ended.out;
    EXPECT_FALSE(fs::exists(folder / "output"));
    const Ended json = film({"--dry-run", "--json"});
    EXPECT_TRUE(json.out.starts_with("{\"event\":\"plan\"")) << json.out;
}

// The prediction is compared with the memory of the drawing process, the largest of the run.
TEST_F(Memory, IsPredicted) {
    const std::vector<std::vector<std::string>> ways = {
        {"--samples", "1"}, {"--blur", "4"}, {"--pass", "normal,flow"}};
    int number = 0;
    for (const char* size : {"320x180", "1280x720"})
        for (const std::vector<std::string>& way : ways) {
            std::vector<std::string> arguments = {
                "render", "ball.toml", "--size", size, "--seconds", "0.1",
                "--jobs", "1",         "-o",     "of" + std::to_string(number++)};
            arguments.insert(arguments.end(), way.begin(), way.end());
            const double used = static_cast<double>(run(folder.path(), arguments).peakKiB) * 1024;
            arguments.insert(arguments.end(), {"--dry-run", "--overwrite"});
            const Ended plan = run(folder.path(), arguments);
            const std::size_t at = plan.out.find("process of ");
            ASSERT_NE(at, std::string::npos) << plan.out;
            const double told = std::atof(plan.out.c_str() + at + 11) * 1e6;
            EXPECT_LT(used, 1.15 * told) << size << " " << way[0] << " " << way[1];
            EXPECT_GT(used, 0.7 * told) << size << " " << way[0] << " " << way[1];
        }
}

TEST_F(Memory, TooMuchOfItIsRefusedBeforeAnythingIsDrawn) {
    const Ended ended =
        run(folder.path(), {"render", "ball.toml", "--size", "8192x8192", "--jobs", "256"});
    EXPECT_EQ(ended.code, 4);
    EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    EXPECT_NE(ended.err.find("30 drawing processes at 8192x8192"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find(" fits"), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(folder / "output"));
}

TEST_F(Memory, OfAStillIsRefusedBeyondTheLimitOfAProcess) {
    Launch launch;
    launch.folder = folder.path();
    launch.arguments = {"still", "ball.toml", "--size", "16384x16384"};
    launch.beforeExec = [] {
        const rlimit limit{rlim_t{4} << 30, rlim_t{4} << 30};
        setrlimit(RLIMIT_AS, &limit);
    };
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 4);
    EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    EXPECT_NE(ended.err.find("a process may have 4.3 GB here (ulimit -v); a smaller --size fits"),
              std::string::npos)
        << ended.err;
    EXPECT_LT(ended.peakKiB, 200 * 1024);
}

/// The value of a variable in the environment with which a process was started.
std::string startedWith(pid_t process, const std::string& name) {
    std::ifstream file("/proc/" + std::to_string(process) + "/environ");
    for (std::string entry; std::getline(file, entry, '\0');)
        if (entry.starts_with(name + "=")) return entry.substr(name.size() + 1);
    return "none";
}

TEST_F(Memory, HasLargePagesUnlessTheUserHasChosen) {
    constexpr const char* kName = "GLIBC_TUNABLES";
    const std::string choices = contentOf("/sys/kernel/mm/transparent_hugepage/enabled");
    const bool areLeftToUs = choices.find("[madvise]") != std::string::npos;
    const std::pair<const char*, std::string> cases[] = {
        {nullptr, areLeftToUs ? "glibc.malloc.hugetlb=1" : "none"},
        {"", ""},
        {"glibc.malloc.check=0", "glibc.malloc.check=0"}};
    for (const auto& [users, expected] : cases) {
        std::string found;
        Launch launch = small(folder.path(), {"-o", "two words", "--json", "--overwrite"});
        launch.beforeExec = [value = users] {
            value ? setenv(kName, value, 1) : unsetenv(kName);
        };
        launch.awaited = "\"frame\":1,";
        launch.awaitedCall = [&found](pid_t process) { found = startedWith(process, kName); };
        const Ended ended = run(launch);
        EXPECT_EQ(ended.code, 0) << ended.err;
        EXPECT_EQ(found, expected);
        EXPECT_EQ(framesIn(folder / "two words").size(), 10u);
    }
}

}  // namespace
}  // namespace demos::test
