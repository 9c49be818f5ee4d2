// include = ["parts/floor.toml"]: several files, one scene.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "demos/load/load_scene.h"
#include "tests/demos/reading.h"
#include "tests/support/temporary_folder.h"

namespace demos::test {
namespace {

namespace fs = std::filesystem;

class Include : public testing::Test {
protected:
    void write(const std::string& name, const std::string& text) {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name, std::ios::binary) << "format = 1\n" << text;
    }

    SceneDescription load(const std::vector<std::string>& overrides = {}) {
        return loadScene((folder_ / "main.toml").string(), overrides);
    }

    std::vector<std::string> errors() {
        try {
            load();
        } catch (const SceneError& error) {
            return error.lines();
        }
        return {};
    }

    /// `main.toml:2:12: ` with the folder.
    std::string at(const std::string& place) { return (folder_ / place).string() + ": "; }

    support::TemporaryFolder folder_;
};

TEST_F(Include, TheSceneNamesTheFilesInTheOrderOfReading) {
    write("main.toml", "include = ['parts/a.toml', 'b.toml']\n" + kBall + kFloor);
    write("parts/a.toml", "include = '../b.toml'\n");
    write("b.toml", "[[section]]\nat = 1\nname = 'of b'\n");
    const SceneDescription scene = load();
    EXPECT_EQ(scene.files, (std::vector<std::string>{(folder_ / "parts/a.toml").string(),
                                                     (folder_ / "b.toml").string()}));
    ASSERT_EQ(scene.sections.size(), 1u);
    EXPECT_EQ(scene.sections[0].file, (folder_ / "b.toml").string());
    EXPECT_EQ(scene.sections[0].place.line, 2);
}

TEST_F(Include, ListsAppendTablesMergeAndTheIncluderWins) {
    write("main.toml",
          "include = ['parts/floor.toml', 'parts/look.toml']\ntitle = 'main'\n"
          "[values]\nradius = 0.25\n[look]\ntheme = 'dark'\n" +
              kBall + "mass = 'twice'\n");
    write("parts/floor.toml",
          "title = 'floor'\nseconds = 3\n[values]\nradius = 0.5\n"
          "twice = '2 * radius'\n" +
              kFloor);
    write("parts/look.toml",
          "[look]\ntheme = 'print'\nghost_every = 0.125\n"
          "[[body]]\nname = 'post'\nshape = { sphere = 0.1 }\nat = [9, 9, 0]\n");
    const SceneDescription scene = load();
    EXPECT_EQ(scene.title, "main");
    EXPECT_EQ(scene.seconds, 3.0);
    EXPECT_EQ(scene.look.theme, "dark");
    EXPECT_EQ(scene.look.ghostEvery, 0.125);
    ASSERT_EQ(scene.bodies.size(), 3u);
    EXPECT_EQ(scene.bodies[0].name, "floor");
    EXPECT_EQ(scene.bodies[1].name, "post");
    EXPECT_EQ(scene.bodies[2].name, "ball");
    EXPECT_EQ(scene.bodies[2].def.mass, 0.5);  // the includer's radius, in the included formula
    EXPECT_EQ(load({"values.radius=2"}).bodies[2].def.mass, 4.0);
}

TEST_F(Include, OneFileOnceHoweverManyNameIt) {
    write("main.toml", "include = ['a.toml', './b.toml']\n" + kBall);
    write("a.toml", "include = 'b.toml'\n");
    write("b.toml", kFloor);
    EXPECT_EQ(load().bodies.size(), 2u);
}

TEST_F(Include, ComplaintsNameTheFile) {
    write("main.toml", "include = ['parts/floor.toml']\nsecods = 1\n" + kBall);
    write("parts/floor.toml", kFloor + "mas = 1\n");
    const std::vector<std::string> lines = errors();
    ASSERT_EQ(lines.size(), 2u) << listed(lines);
    EXPECT_TRUE(tells({lines[0]}, at("parts/floor.toml:6:1"), "unknown key 'mas' in a [[body]]"));
    EXPECT_TRUE(tells({lines[1]}, at("main.toml:3:1"), "did you mean 'seconds'?"));
}

TEST_F(Include, LongPathsAreReportedByTheirBeginning) {
    write("main.toml", "include = '" + std::string(5000, 'p') + "'\n" + kBall);
    EXPECT_TRUE(tells(errors(), at("main.toml:2:11"),
                      "include is '" + std::string(64, 'p') +
                          "...' of 5000 characters; it should be at most 1000"));
}

TEST_F(Include, BadTomlInAnIncludedFileIsReportedThere) {
    write("main.toml", "include = ['part.toml']\n" + kBall);
    write("part.toml", "x = = 1\n");
    EXPECT_TRUE(tells(errors(), at("part.toml:2:5"), "not TOML"));
}

TEST_F(Include, AsksForTheFormatOfEveryFile) {
    write("main.toml", "include = ['part.toml']\n" + kBall);
    std::ofstream(folder_ / "part.toml") << kFloor;
    EXPECT_TRUE(tells(errors(), at("part.toml:1:1"), "begin it with format = 1"));
    std::ofstream(folder_ / "part.toml") << "format = 2\n";
    EXPECT_TRUE(tells(errors(), at("part.toml:1:10"), "this version reads format 1"));
}

TEST_F(Include, WhatIsNoFileIsReportedWhereItIsNamed) {
    fs::create_directory(folder_ / "folder");
    ASSERT_EQ(mkfifo((folder_ / "fifo").c_str(), 0600), 0);
    std::ofstream(folder_ / "large.toml") << "format = 1\n#" << std::string(8u << 20, 'x');
    std::ofstream(folder_ / "half.toml") << "format = 1\n#" << std::string(5u << 20, 'x');
    std::ofstream(folder_ / "other.toml") << "format = 1\n#" << std::string(5u << 20, 'x');
    write("main.toml",
          "include = ['no.toml',\n'folder',\n'fifo',\n'/dev/zero',\n'large.toml',\n"
          "'',\n'half.toml', 'other.toml']\n" +
              kBall);
    const std::vector<std::string> lines = errors();
    EXPECT_TRUE(tells(lines, at("main.toml:2:12"), "no.toml: there is no such file"))
        << listed(lines);
    EXPECT_TRUE(tells(lines, at("main.toml:3:1"), "is a directory"));
    EXPECT_TRUE(tells(lines, at("main.toml:4:1"), "not a regular file"));
    EXPECT_TRUE(tells(lines, at("main.toml:5:1"), "/dev/zero: is not a regular file"));
    EXPECT_TRUE(tells(lines, at("main.toml:6:1"), "it should be at most 8 MiB"));
    EXPECT_TRUE(tells(lines, at("main.toml:7:1"), "include is ''"));
    EXPECT_TRUE(tells(lines, at("main.toml:8:14"), "more than 8 MiB in all files"));
}

TEST_F(Include, IsAListOfTexts) {
    write("main.toml", "include = [1]\n" + kBall);
    EXPECT_TRUE(
        tells(errors(), at("main.toml:2:11"), "include is a list of 1; it should be files"));
    write("main.toml", "include = true\n" + kBall);
    EXPECT_TRUE(tells(errors(), at("main.toml:2:11"), "include is true; it should be files"));
}

TEST_F(Include, NoCycles) {
    write("main.toml", "include = ['a.toml']\n" + kBall);
    write("a.toml", "include = ['sub/../main.toml']\n");
    EXPECT_TRUE(tells(errors(), at("a.toml:2:12"), "includes itself, by way of a.toml"));
    write("a.toml", "include = ['a.toml']\n");
    EXPECT_TRUE(tells(errors(), at("a.toml:2:12"), "includes itself"));
}

TEST_F(Include, EightDeepAndNoDeeper) {
    write("main.toml", "include = '1.toml'\n" + kBall);
    for (int i = 1; i < 8; ++i)
        write(std::to_string(i) + ".toml", "include = '" + std::to_string(i + 1) + ".toml'\n");
    write("8.toml", "");
    EXPECT_NO_THROW(load());
    write("8.toml", "include = '9.toml'\n");
    write("9.toml", "");
    EXPECT_TRUE(tells(errors(), at("8.toml:2:11"), "more than 8 deep"));
}

TEST_F(Include, SixtyFourFilesAndNoMore) {
    std::string list;
    for (int i = 1; i < 64; ++i) {
        std::string name("p");
        name += std::to_string(i);
        name += ".toml";
        write(name, "");
        list += '\'';
        list += name;
        list += "',\n";
    }
    write("main.toml", "include = [\n" + list + "]\n" + kBall);
    EXPECT_NO_THROW(load());
    write("last.toml", "");
    write("main.toml", "include = [\n" + list + "'last.toml']\n" + kBall);
    EXPECT_TRUE(tells(errors(), at("main.toml:66:1"), "more than 64 files"));
}

TEST_F(Include, IsForFilesOnly) {
    EXPECT_TRUE(tells(errorsOf("format = 1\ninclude = 'b.toml'\n" + kBall), "a.toml:2:11: ",
                      "cannot include others; save it with 'impulse list NAME --print'"));
}

TEST_F(Include, BelongsToTheTextOfAScene) {
    write("main.toml", "include = ['part.toml']\n" + kBall);
    write("part.toml", kFloor);
    const std::string path = (folder_ / "main.toml").string(), before = sceneText(path);
    write("part.toml", kFloor + "# changed\n");
    EXPECT_NE(sceneText(path), before);
}

}  // namespace
}  // namespace demos::test
