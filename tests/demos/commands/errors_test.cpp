/// Every invalid input gives the documented code and one line per error, and nothing is written.
#include <sys/stat.h>

#include "tests/demos/program.h"

namespace demos::test {
namespace {

struct Bad {
    const char* name;
    std::vector<std::string> arguments;
    int code;
    const char* part;  // of the line
};
void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.name; }

class BadCommandLine : public testing::TestWithParam<Bad> {};

TEST_P(BadCommandLine, IsOneLineAndACode) {
    const TemporaryFolder folder;
    const Ended ended = run(folder.path(), GetParam().arguments);
    EXPECT_EQ(ended.code, GetParam().code) << ended.err;
    EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    EXPECT_NE(ended.err.find(GetParam().part), std::string::npos) << ended.err;
    EXPECT_TRUE(ended.out.empty()) << ended.out;
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

INSTANTIATE_TEST_SUITE_P(
    Table, BadCommandLine,
    testing::ValuesIn(std::vector<Bad>{
        {"NoCommand", {}, 2, "known are: render"},
        {"UnknownCommand", {"rnder"}, 2, "did you mean 'render'"},
        {"UnknownOption", {"sim", "stack", "--evry", "2"}, 2, "did you mean '--every'"},
        {"UnknownShortOption", {"export", "stack", "-q", "draft"}, 2, "-q: export has no such"},
        {"UnknownShortOfSlides", {"slides", "stack", "-qdraft"}, 2, "-q: slides has no such"},
        {"NoScene", {"render"}, 2, "needs a scene"},
        {"TwoScenes", {"sim", "stack", "wall"}, 2, "one scene"},
        {"UnknownScene", {"sim", "stakc"}, 3, "did you mean 'stack'"},
        {"Urdf", {"render", "robot.urdf"}, 3, "robot.urdf: URDF is not supported; MuJoCo's models"},
        {"UnknownListed", {"list", "stakc"}, 2, "did you mean 'stack'"},
        {"NoNumber", {"render", "stack", "--fps", "many"}, 2, "must be a whole number"},
        {"NoFrameRate", {"render", "stack", "--fps", "0"}, 2, "1 to 1000"},
        {"OddFrameRate", {"render", "stack", "--fps", "7"}, 2,
         "good: 2 3 4 5 6 10, or --set world.hz=63"},
        {"FrameRateAboveSteps", {"render", "stack", "--fps", "1000"}, 2, "world.hz=1000"},
        {"FrameRateOfFewSteps",
         {"render", "stack", "--set", "world.hz=10", "--fps", "7"},
         2,
         "good: 1 2 5 10, or --set world.hz=14"},
        {"FrameRateOfManySteps",
         {"render", "stack", "--set", "world.hz=100000", "--fps", "991"},
         2,
         "or --set world.hz=99100"},
        {"NoWidth", {"render", "stack", "--size", "0x9"}, 2, "1 to 16384"},
        {"WideWidth", {"render", "stack", "--size", "16385x9"}, 2, "1 to 16384"},
        {"NoSize", {"render", "stack", "--size", "big"}, 2, "1280x720"},
        {"SizeWithMore", {"render", "stack", "--size", "9x9x9"}, 2, "1280x720"},
        {"TwoSizes", {"render", "stack", "--size", "9x9", "--size", "8x8"}, 2, "more than once"},
        {"Samples", {"render", "stack", "--samples", "3"}, 2, "1, 2, 4, 8 or 16"},
        {"Quality", {"render", "stack", "-q", "hihg"}, 2, "did you mean 'high'"},
        {"Overlay", {"render", "stack", "--show", "contact"}, 2, "did you mean 'contacts'"},
        {"Theme", {"render", "stack", "--theme", "drak"}, 2, "did you mean 'dark'"},
        {"SecondsNan", {"sim", "stack", "--seconds", "nan"}, 2, "above 0"},
        {"SecondsHuge", {"sim", "stack", "--seconds", "1e999"}, 2, "above 0"},
        {"SecondsNone", {"sim", "stack", "--seconds", "0"}, 2, "above 0"},
        {"TooManyFrames", {"render", "stack", "--seconds", "1e5"}, 2, "at most 1000000"},
        {"TimeBefore", {"still", "stack", "-t", "-1"}, 2, "0 to 100000"},
        {"FrameAfter", {"still", "stack", "-f", "99999"}, 2, "frames 0 to"},
        {"FrameAndTime", {"still", "stack", "-f", "1", "-t", "1"}, 2, "excludes"},
        {"StillEnding", {"still", "stack", "-o", "a.jpg"}, 2, ".png"},
        {"Every", {"sim", "stack", "--every", "0"}, 2, "must be 1"},
        {"SetWithoutValue", {"sim", "stack", "--set", "world.hz"}, 2, "KEY=VALUE"},
        {"SetWithoutKey", {"sim", "stack", "--set", "=3"}, 2, "--set '=3': must be KEY=VALUE"},
        {"SetBadValue", {"sim", "stack", "--set", "world.hz=abc"}, 3, "world.hz=abc"},
        {"Solver", {"sim", "stack", "--solver", "magic"}, 3, "magic"},
        {"Ending", {"render", "stack", "-o", "a.avi"}, 2, "known are: .png"},
        {"OneName", {"render", "stack", "-o", "a.png"}, 2, "####"},
        {"FrameFolder", {"render", "stack", "-o", "{frame}/a.png"}, 2, "one folder"},
        {"PatternHole", {"render", "stack", "-o", "{farme}.png"}, 2, "did you mean 'frame'"},
        {"TwiceOnePlace", {"render", "stack", "-o", "a", "-o", "a"}, 2, "another --output"},
        {"RawAndJson", {"render", "stack", "-o", "-", "--json"}, 2, "standard output"},
        {"TwoTables", {"sim", "stack", "--csv", "-", "--bodies", "-"}, 2, "two tables"},
        {"Shell", {"completion", "powershell"}, 2, "known are: bash, zsh, fish"},
        {"SizeBelowZero", {"render", "stack", "--size", "-5x10"}, 2, "1 to 16384"},
        {"SizeOverflow", {"render", "stack", "--size", "99999999999x9"}, 2, "1280x720"},
        {"SizeEmpty",
         {"render", "stack", "--size", ""},
         2,
         "'--size' is followed by an empty word"},
        {"SecondsEmpty", {"render", "stack", "--seconds="}, 2, "'--seconds=' has no value"},
        {"SizeAlone", {"render", "stack", "--size"}, 2, "--size needs a value"},
        {"FrameRateBroken",
         {"render", "stack", "--fps", "29.97"},
         2,
         "--fps 29.97: must be a whole"},
        {"FrameRateHigh", {"render", "stack", "--fps", "1001"}, 2, "1 to 1000"},
        {"FrameRateOfGif", {"render", "stack", "--fps", "60", "-o", "a.gif"}, 2, "at most 50"},
        {"SecondsNoNumber", {"render", "stack", "--seconds", "5s"}, 2, "number of seconds"},
        {"SecondsBelowZero", {"render", "stack", "--seconds", "-1"}, 2, "above 0"},
        {"JobsBelowZero", {"render", "stack", "--jobs", "-1"}, 2, "0 to 256"},
        {"JobsMany", {"render", "stack", "--jobs", "257"}, 2, "0 to 256"},
        {"SamplesNone", {"still", "stack", "--samples", "0"}, 2, "1, 2, 4, 8 or 16"},
        {"Context", {"render", "stack", "--context", "glx"}, 2, "known are: auto"},
        {"ContextOfAStill", {"still", "stack", "--context", "ogl"}, 2, "did you mean 'egl'"},
        {"ContextOfASweep",
         {"sweep", "stack", "--over", "solver.sweeps=1,2", "--context", "no"},
         2,
         "known are: auto"},
        {"ThemeCase", {"render", "stack", "--theme", "Dark"}, 2, "did you mean 'dark'"},
        {"QualityCase", {"render", "stack", "-q", "HIGH"}, 2, "did you mean 'high'"},
        {"OverlayAlone", {"render", "stack", "--show"}, 2, "--show needs a value"},
        {"OddSides", {"render", "stack", "-o", "a.mp4", "--size", "99x98"}, 2, "even"},
        {"FilmPattern", {"render", "stack", "-o", "a####.mp4"}, 2, "one file"},
        {"PatternDigits", {"render", "stack", "-o", "{frame:99}.png"}, 2, "at most 12 digits"},
        {"OutputAlone", {"render", "stack", "-o"}, 2, "--output needs a value"},
        {"OutputNoFolder", {"render", "stack", "-o", "/dev/full"}, 4, "not a folder"},
        {"OutputNoFiles",
         {"export", "stack", "--seconds", "1", "-o", "/proc/q.csv"},
         4,
         "no file can be created in its folder"},
        {"OutputNoPlace", {"render", "stack", "-o", "/proc/x/y"}, 4, "cannot create the folder"},
        {"StillFilm", {"still", "stack", "-o", "a.mp4"}, 2, ".png"},
        {"StillFrameBroken", {"still", "stack", "-f", "1.5"}, 2, "whole number"},
        {"StillFrameOverflow", {"still", "stack", "-f", "99999999999"}, 2, "nine digits"},
        {"StillFrameBefore", {"still", "stack", "-f", "-9999"}, 2, "-1 to -"},
        {"StillTimeNan", {"still", "stack", "-t", "nan"}, 2, "0 to 100000"},
        {"StillTimeFar", {"still", "stack", "-t", "1e6"}, 2, "0 to 100000"},
        {"DryRunMisspelt", {"render", "stack", "--dryrun"}, 2, "did you mean '--dry-run'"},
        {"FieldOfView", {"render", "stack", "--set", "camera.fov_deg=0"}, 3, "1 to 170"},
        {"StepsNone", {"render", "stack", "--set", "world.hz=0"}, 3, "10 to 100000"},
        {"Escapes", {"sim", "\x1b[31mred"}, 3, "\\x1b"},
        {"ExplainNothing", {"list", "--explain", "solver.swee"}, 2, "'solver.sweeps'"},
        {"ExplainAScene", {"list", "stack", "--explain", "solver"}, 2, "takes a key and no other"},
        {"SchemaOfAScene", {"list", "stack", "--schema"}, 2, "--schema takes no scene"},
        {"SetOfNoValue", {"sim", "stack", "--set", "values.x=1"}, 3, "no value 'x'"},
        {"SetOfAnExpression", {"sim", "stack", "--set", "camera.fov_deg=1/0"}, 3, "a division by zero"},
        {"SetOfAnInclude", {"sim", "stack", "--set", "include=a"}, 3, "before --set"},
    }),
    [](const testing::TestParamInfo<Bad>& row) { return std::string(row.param.name); });

/// The rates that the message names are taken.
TEST(FrameRate, OfTheMessageIsTaken) {
    const TemporaryFolder folder;
    const auto plan = [&](const std::vector<std::string>& options) {
        std::vector<std::string> words{"render", "stack", "--dry-run", "--fps"};
        words.insert(words.end(), options.begin(), options.end());
        return run(folder.path(), words);
    };
    const Ended refused = plan({"25"});
    ASSERT_NE(refused.err.find("30, or --set world.hz=50\n"), std::string::npos) << refused.err;
    EXPECT_EQ(plan({"30"}).code, 0);
    EXPECT_EQ(plan({"25", "--set", "world.hz=50"}).code, 0);
}

struct BadScene {
    const char* name;
    std::string text;
    const char* part;
};
void PrintTo(const BadScene& bad, std::ostream* out) { *out << bad.name; }

class BadSceneFile : public testing::TestWithParam<BadScene> {};

TEST_P(BadSceneFile, IsCode3AndNamesTheFile) {
    const TemporaryFolder folder;
    write(folder / "bad.toml", GetParam().text);
    const Ended ended = run(folder.path(), {"render", "bad.toml"});
    EXPECT_EQ(ended.code, 3) << ended.err;
    EXPECT_GE(ended.errorLines(), 1);
    EXPECT_NE(ended.err.find("bad.toml"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find(GetParam().part), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(folder / "output"));
}

std::string body(const std::string& lines) {
    return "format = 1\n[[body]]\nname = \"b\"\nshape = { sphere = 0.5 }\n" + lines;
}

INSTANTIATE_TEST_SUITE_P(
    Table, BadSceneFile,
    testing::ValuesIn(std::vector<BadScene>{
        {"Empty", "", "format"},
        {"Nul", std::string("format = 1\n\0", 12), "bad.toml"},
        {"Utf16",
         "\xff\xfe"
         "f",
         "bad.toml"},
        {"Truncated", "format = 1\nseconds = 1.", "2:"},
        {"UnknownKey", "format = 1\nsecnds = 3\n", "did you mean 'seconds'"},
        {"TwiceAKey", "format = 1\nformat = 1\n", "2:"},
        {"WrongType", "format = 1\nseconds = \"five\"\n", "seconds"},
        {"Nan", body("at = [nan, 0, 0]\n"), "at"},
        {"Inf", body("at = [inf, 0, 0]\n"), "at"},
        {"MassNone", body("mass = 0\n"), "mass"},
        {"MassNegative", body("mass = -1\n"), "mass"},
        {"SizeNone", "format = 1\n[[body]]\nname = \"b\"\nshape = { sphere = 0 }\n", "sphere"},
        {"Quaternion", body("quaternion = [0, 0, 0, 0]\n"), "quaternion"},
        {"TwoOfAName", body("[[body]]\nname = \"b\"\nshape = { sphere = 1 }\n"), "'b'"},
        {"JointToNobody",
         body("[[joint]]\ntype = \"ball\"\na = \"b\"\nb = \"c\"\nanchor = [0,0,0]\n"), "'c'"},
        {"JointToItself",
         body("[[joint]]\ntype = \"ball\"\na = \"b\"\nb = \"b\"\nanchor = [0,0,0]\n"), "b"},
        {"CameraInItself", body("[camera]\nfrom = [0,0,0]\nlook_at = [0,0,0]\n"), "same point"},
        {"FieldOfView", body("[camera]\nfov_deg = 180\n"), "fov_deg"},
        {"EscapeInName", "format = 1\n[[body]]\nname = \"a\\u001b[2J\"\nshape = { sphere = 1 }\n",
         "name"},
    }),
    [](const testing::TestParamInfo<BadScene>& row) { return std::string(row.param.name); });

TEST(BadScenePath, WhatIsNoFileIsReported) {
    const TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder / "fifo").c_str(), 0600), 0);
    for (const char* path : {"./fifo", "/dev/zero", "/", "./missing.toml"}) {
        const Ended ended = run(folder.path(), {"sim", path});
        EXPECT_EQ(ended.code, 3) << path;
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    }
}

TEST(SetOption, IsTakenByEveryCommandThatPlaysAScene) {
    const TemporaryFolder folder;
    const std::vector<std::vector<std::string>> commands{
        {"render", "stack"},
        {"still", "stack"},
        {"strip", "stack"},
        {"sim", "stack"},
        {"plot", "stack"},
        {"export", "stack"},
        {"bench", "stack"},
        {"compare", "stack", "--vary", "solver.nudges=0,4"},
        {"sweep", "stack", "--over", "solver.sweeps=1,2"}};
    for (std::vector<std::string> command : commands) {
        command.insert(command.end(), {"--set", "world.hzz=3"});
        const Ended ended = run(folder.path(), command);
        EXPECT_EQ(ended.code, 3) << command[0] << "\n" << ended.err;
        EXPECT_NE(ended.err.find("--set world.hzz=3: unknown key 'hzz' in [world]; did you mean "
                                 "'hz'?"),
                  std::string::npos)
            << command[0] << "\n"
            << ended.err;
    }
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(IncludedFile, IsReportedByItsOwnName) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "parts");
    write(folder / "main.toml", "include = [\"parts/floor.toml\"]\n" + kBall);
    write(folder / "parts/floor.toml", "format = 1\nsecods = 3\n");
    const Ended ended = run(folder.path(), {"sim", "main.toml"});
    EXPECT_EQ(ended.code, 3);
    EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    EXPECT_TRUE(ended.err.starts_with("impulse: parts/floor.toml:2:1: unknown key 'secods'"))
        << ended.err;
}

TEST(Errors, NoEscapeBytesReachTheTerminal) {
    const TemporaryFolder folder;
    write(folder / "bad.toml", "format = 1\n\"\x1b[31mkey\" = 1\n\"k\\u001b[31m\" = 2\n");
    const Ended ended = run(folder.path(), {"sim", "bad.toml"});
    EXPECT_EQ(ended.code, 3);
    EXPECT_EQ(ended.err.find('\x1b'), std::string::npos) << ended.err;
}

TEST(Help, ShowsThreeExamplesFirst) {
    for (const char* command :
         {"render", "still", "sim", "list", "doctor", "bench", "completion", "man"}) {
        const Ended ended = run(fs::temp_directory_path(), {command, "--help"});
        EXPECT_EQ(ended.code, 0);
        EXPECT_TRUE(ended.out.starts_with("Examples:\n  ")) << ended.out;
        const std::string call = std::string("\n  impulse ") + command;
        EXPECT_NE(ended.out.substr(9).find(call), std::string::npos) << ended.out;
        EXPECT_TRUE(ended.err.empty());
    }
}

TEST(List, PrintsSceneFilesThatPlay) {
    const TemporaryFolder folder;
    const Ended printed = run(folder.path(), {"list", "pendulum", "--print"});
    ASSERT_EQ(printed.code, 0);
    write(folder / "mine.toml", printed.out);
    const Ended own = run(folder.path(), {"sim", "mine.toml", "--hash", "--seconds", "0.5",
                                          "--no-expect", "--quiet"});
    const Ended builtin = run(
        folder.path(), {"sim", "pendulum", "--hash", "--seconds", "0.5", "--no-expect", "--quiet"});
    EXPECT_EQ(own.code, 0) << own.err;
    EXPECT_EQ(own.out, builtin.out);
    EXPECT_FALSE(own.out.empty());
}

}  // namespace
}  // namespace demos::test
