/// 'impulse export': the files that are written, and what is refused.
#include "tests/demos/export/glb_reading.h"
#include "tests/demos/program.h"

namespace demos::test {
namespace {

class Export : public testing::Test {
protected:
    Export() { write(folder / "ball.toml", kBall); }
    Ended command(std::vector<std::string> arguments) {
        return run(folder.path(), std::move(arguments));
    }
    Ended exported(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"export", "ball.toml"});
        return command(std::move(arguments));
    }
    Glb glb(const std::string& name) const {
        const std::string bytes = contentOf(folder / name);
        return readGlb({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    }
    /// The scene, and what is named.
    long files() const { return std::distance(fs::directory_iterator(folder.path()), {}); }
    TemporaryFolder folder;
};

TEST_F(Export, WritesAGlbNamedAfterTheScene) {
    const Ended ended = exported({});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.out,
              "wrote output/ball.glb (31 frames, 2 bodies)\nnext: impulse render ball.toml\n");
    const Glb read = glb("output/ball.glb");
    const auto places = read.motion(read.numberOf("ball"), "translation");
    ASSERT_EQ(places.size(), 3u * 31u);  // a second of 30 frames, and its end
    EXPECT_EQ(places[1], 3.0f);
    EXPECT_LT(places[91], 1.0f);
}

TEST_F(Export, WhatIsNextIsWordsOfAShell) {
    fs::create_directory(folder / "a b");
    write(folder / "a b/it's.toml", kBall);
    EXPECT_NE(command({"export", "a b/it's.toml"})
                  .out.find("next: impulse render 'a b/it'\\''s.toml'\n"),
              std::string::npos);
}

TEST_F(Export, LessThanAFrameIsReported) {
    const Ended ended = exported({"--seconds", "0.001"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("(1 frame, 2 bodies)"), std::string::npos) << ended.out;
    EXPECT_NE(ended.err.find("--seconds 0.001: less than one frame (0.0333 s)"),
              std::string::npos)
        << ended.err;
}

// At any frame rate, all three files agree with 'sim' at those steps.
TEST_F(Export, TablesAndEventsAreThoseOfSim) {
    const Ended ended = exported({"-o", "a.csv", "-o", "deep/a.json", "--fps", "20"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("wrote a.csv (21 frames, 2 bodies)\n"), std::string::npos);
    EXPECT_EQ(command({"sim", "ball.toml", "--bodies", "b.csv", "--every", "3", "--events",
                       "b.json", "--no-expect"})
                  .code,
              0);
    EXPECT_EQ(contentOf(folder / "a.csv"), contentOf(folder / "b.csv"));
    EXPECT_EQ(contentOf(folder / "deep/a.json"), contentOf(folder / "b.json"));
    EXPECT_NE(contentOf(folder / "b.json").find("\"begin\""), std::string::npos);
}

TEST_F(Export, NumpyReadsWhatSimSays) {
    const char* numpy = "/usr/bin/python3 -c 'import numpy' 2> /dev/null";
    if (std::system(numpy) != 0) GTEST_SKIP() << "no numpy: install python3-numpy";
    write(folder / "ball.toml", kBall +
                                    "spin = [1, 2, 3]\nvelocity = [1, 0, 0]\n[[body]]\nname = "
                                    "'crate'\nshape = { box = [1, 1, 1] }\nat = [5, 0.5, 0]\n");
    EXPECT_EQ(exported({"-o", "a.npz"}).code, 0);
    EXPECT_EQ(
        command({"sim", "ball.toml", "--bodies", "b.csv", "--csv", "e.csv", "--every", "2"}).code,
        0);
    const std::string check = "cd '" + folder.path().string() + "' && /usr/bin/python3 '" +
                              IMPULSE_SOURCE_DIR "/tests/demos/export/check_npz.py' a.npz b.csv e.csv";
    EXPECT_EQ(std::system(check.c_str()), 0);
}

TEST_F(Export, IsTheSameFileEveryTime) {
    const std::vector<std::string> names = {"a.glb", "a.npz", "a.csv", "a.json", "a.html"};
    std::vector<std::string> arguments;
    for (const std::string& name : names) arguments.insert(arguments.end(), {"-o", name});
    EXPECT_EQ(exported(arguments).code, 0);
    std::vector<std::string> first;
    for (const std::string& name : names) first.push_back(contentOf(folder / name));
    arguments.push_back("--overwrite");
    EXPECT_EQ(exported(arguments).code, 0);
    for (std::size_t i = 0; i < names.size(); ++i)
        EXPECT_TRUE(first[i] == contentOf(folder / names[i])) << names[i];
}

TEST_F(Export, SetAndSecondsChangeWhatIsPlayed) {
    const Ended ended =
        exported({"-o", "a.csv", "--seconds", "0.5", "--set", "world.gravity=[0,0,0]", "--quiet"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(ended.out.empty());
    const std::string text = contentOf(folder / "a.csv");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 16 * 2);
    EXPECT_NE(text.find("\n0.5,ball,0,3,0,1,0,0,0,0,0,0,0,0,0\n"), std::string::npos) << text;
}

TEST_F(Export, ReplacesNothingUnlessTold) {
    write(folder / "a.glb", "mine");
    const Ended refused = exported({"-o", "b.csv", "-o", "a.glb"});
    EXPECT_EQ(refused.code, 5);
    EXPECT_EQ(refused.errorLines(), 1) << refused.err;
    EXPECT_EQ(contentOf(folder / "a.glb"), "mine");
    EXPECT_EQ(files(), 2);
    EXPECT_EQ(exported({"-o", "a.glb", "--overwrite"}).code, 0);
    EXPECT_TRUE(contentOf(folder / "a.glb").starts_with("glTF"));
}

struct BadExport {
    const char* name;
    std::vector<std::string> arguments;
    int code;
    const char* part;
};

TEST_F(Export, BadOptionsAreOneLineAndLeaveNothing) {
    const std::vector<BadExport> rows = {
        {"extension", {"-o", "a.usd"}, 2, "known are: .glb .csv .npz .json .html"},
        {"no extension", {"-o", "a"}, 2, "the file extension selects the format"},
        {"standard output", {"-o", "-"}, 2, "the file extension selects the format"},
        {"empty", {"-o", ""}, 2, "give it a value"},
        {"second extension", {"-o", "a.glb", "-o", "a.obj"}, 2, "'a.obj'"},
        {"twice", {"-o", "a.glb", "-o", "./a.glb"}, 2, "another --output goes there"},
        {"the scene", {"-o", "ball.toml"}, 2, "is the scene itself"},
        {"frame rate", {"--fps", "7"}, 2, "good: "},
        {"no frame rate", {"--fps", "0"}, 2, "1 to 1000"},
        {"seconds", {"--seconds", "nan"}, 2, "above 0"},
        {"frames", {"--seconds", "1e5", "--fps", "60"}, 2, "at most 1000000"},
        {"option", {"--overwrit"}, 2, "did you mean '--overwrite'"},
        {"set", {"--set", "world.hz=abc"}, 3, "world.hz=abc"},
        {"folder", {"-o", "ball.toml/a.glb"}, 4, "ball.toml"},
    };
    for (const BadExport& row : rows) {
        const Ended ended = exported(row.arguments);
        EXPECT_EQ(ended.code, row.code) << row.name << ": " << ended.err;
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
        EXPECT_NE(ended.err.find(row.part), std::string::npos) << row.name << ": " << ended.err;
        EXPECT_TRUE(ended.out.empty()) << ended.out;
        EXPECT_EQ(files(), 1) << row.name;
    }
}

// A link to the scene, a part of a model and an included file are not overwritten.
TEST_F(Export, SparesWhatTheSceneIsMadeOf) {
    fs::create_hard_link(folder / "ball.toml", folder / "a.csv");
    const Ended own = exported({"-o", "a.csv", "--overwrite"});
    EXPECT_EQ(own.code, 2);
    EXPECT_NE(own.err.find("is the scene itself"), std::string::npos) << own.err;
    EXPECT_EQ(contentOf(folder / "ball.toml"), kBall);
    const std::string part =
        "<mujoco><worldbody><geom type='plane' size='1 1 1'/></worldbody></mujoco>";
    write(folder / "part.csv", part);
    write(folder / "model.xml", "<mujoco><include file='part.csv'/></mujoco>");
    const Ended other = command({"export", "model.xml", "-o", "part.csv", "--overwrite"});
    EXPECT_EQ(other.code, 2) << other.err;
    EXPECT_NE(other.err.find("the scene reads this file"), std::string::npos) << other.err;
    EXPECT_EQ(contentOf(folder / "part.csv"), part);
    write(folder / "own.csv", "format = 1\n");
    write(folder / "a.toml", "include = 'own.csv'\n" + kBall);
    const Ended included = command({"export", "a.toml", "-o", "own.csv", "--overwrite"});
    EXPECT_EQ(included.code, 2) << included.err;
    EXPECT_NE(included.err.find("the scene reads this file"), std::string::npos) << included.err;
}

TEST_F(Export, TooManyPosesAreRefused) {
    write(folder / "ball.toml", kBall +
                                    "[[repeat]]\ncount = 99\nstep = [2, 0, 0]\nbody = { name = "
                                    "'b{i}', shape = { sphere = 0.5 }, at = [2, 9, 0] }\n");
    const Ended ended = exported({"--seconds", "10000"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    EXPECT_NE(ended.err.find("101 bodies in 300000 frames; an export holds at most 10 million"),
              std::string::npos)
        << ended.err;
}

TEST_F(Export, ADivergedRunIsCode6AndStillWritten) {
    write(folder / "ball.toml", kBall + "velocity = [0, 9999, 0]\n");
    const Ended ended = exported({"--set", "world.gravity=[0,100,0]", "-o", "a.csv"});
    EXPECT_EQ(ended.code, 6) << ended.err;
    EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    EXPECT_TRUE(contentOf(folder / "a.csv").ends_with("\n"));
}

TEST_F(Export, JsonNamesTheFiles) {
    const Ended ended = exported({"-o", "a.glb", "-o", "a.json", "--json"});
    EXPECT_EQ(ended.code, 0);
    const std::size_t size = fs::file_size(folder / "a.glb");
    EXPECT_NE(ended.out.find(R"({"event":"export","file":"a.glb","frames":31,"bodies":2,)"),
              std::string::npos)
        << ended.out;
    EXPECT_NE(ended.out.find("\"bytes\":" + std::to_string(size) + "}\n"), std::string::npos);
    EXPECT_NE(ended.out.find(R"({"event":"done","steps":60,"state":")"), std::string::npos);
}

TEST(ExportHelp, ShowsThreeExamplesFirstAndIsCompleted) {
    const Ended ended = run(fs::temp_directory_path(), {"export", "--help"});
    EXPECT_EQ(ended.code, 0);
    EXPECT_TRUE(ended.out.starts_with("Examples:\n  impulse export ")) << ended.out;
    for (const char* word : {".glb", ".csv", ".npz", ".json", ".html", "--fps", "--bodies", "--events"})
        EXPECT_NE(ended.out.find(word), std::string::npos) << word;
    const Ended completion = run(fs::temp_directory_path(), {"completion", "bash"});
    EXPECT_NE(completion.out.find("export) words=\""), std::string::npos);
}

}  // namespace
}  // namespace demos::test
