// The values of a scene file, and the defaults of those that are missing.

#include "demos/scene/reader.h"
#include "demos/load/load_scene.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "demos/scene/pattern.h"
#include "demos/text/nearest.h"
#include "render/frame.h"
#include "tests/demos/reading.h"

namespace demos::test {
namespace {

TEST(Reader, FillsInDefaults) {
    const SceneDescription scene = read(kFloor + kBall);
    EXPECT_EQ(scene.title, "a");
    EXPECT_EQ(scene.hz, 60);
    EXPECT_EQ(scene.gravity, Vec3(0, -9.81, 0));
    EXPECT_EQ(scene.preset, "steady");
    EXPECT_EQ(scene.settings.substeps, engine::Settings::steady().substeps);
    EXPECT_EQ(scene.look.theme, "studio");
    EXPECT_EQ(scene.snapshot.width, 640);
    ASSERT_EQ(scene.bodies.size(), 2u);
    EXPECT_EQ(scene.bodies[1].def.material.density, 1000.0);
    EXPECT_EQ(scene.bodies[1].place.line, 6);
}

TEST(Reader, TakesLettersBeyondAsciiInTextsAndComments) {
    EXPECT_EQ(read("title = '\u00e9' # \u03bb\n" + kBall).title, "\u00e9");
    EXPECT_EQ(read("title = \"\"\"a\\\n  \u00e9\"\"\"\n" + kBall).title, "a\u00e9");
    // Up to two of the quotes at the end of a block belong to the text.
    EXPECT_EQ(read("title = '''\u00e9'''''\n" + kBall).title, "\u00e9''");
    EXPECT_EQ(readScene("\ufeffformat = 1\n" + kBall, "a.toml", "a").bodies.size(), 1u);
}

TEST(Reader, TakesTheLookOfABodyOrOfItsMaterial) {
    const std::string floor = "[[material]]\nname = 'm'\nlook = 'brick'\n";
    const SceneDescription scene =
        read(floor + "[[body]]\nname = 'a'\nshape = { sphere = 1 }\nmaterial = 'm'\n"
                     "[[body]]\nname = 'b'\nshape = { sphere = 1 }\nmaterial = 'm'\n"
                     "look = 'glass'\n[[body]]\nname = 'c'\nshape = { sphere = 1 }\n");
    EXPECT_EQ(scene.bodies[0].look, render::Material::brick);
    EXPECT_EQ(scene.bodies[1].look, render::Material::glass);
    EXPECT_EQ(scene.bodies[2].look, render::Material::plastic);
}

TEST(Reader, ReadsABodyInFull) {
    const SceneDescription scene = read(
        "[[material]]\nname = 'm'\ndensity = 600\nfriction = 0.1\nrestitution = 0.2\nrolling = 0.03\n"
        "colour = '#0a0B0c'\n" +
        kBall +
        "turn_deg = [0, 0, 90]\nvelocity = [1, 2, 3]\nspin = [4, 5, 6]\nmass = 7\n"
        "inertia = [2, 3, 4, 0.1, 0.2, 0.3]\nmaterial = 'm'\n");
    const BodyDescription& body = scene.bodies.at(0);
    EXPECT_EQ(body.def.velocity, Vec3(1, 2, 3));
    EXPECT_EQ(body.def.spin, Vec3(4, 5, 6));
    EXPECT_EQ(body.def.mass, 7.0);
    EXPECT_EQ((*body.def.inertia)(2, 1), 0.3);
    EXPECT_EQ(body.def.material.friction, 0.1);
    EXPECT_EQ(body.def.material.rolling, 0.03);
    EXPECT_EQ(body.color, 0x0a0b0cu);
    EXPECT_NEAR((body.def.pose.rotation * Vec3(1, 0, 0) - Vec3(0, 1, 0)).norm(), 0.0, 1e-15);
}

TEST(Reader, ReadsASeedSolver) {
    const SceneDescription scene =
        read("[solver]\npreset = 'seed'\nsweeps = 4\nbaumgarte = 0.2\nnudges = 0\n" + kBall);
    EXPECT_EQ(scene.settings.sweeps, 4);
    EXPECT_EQ(scene.settings.minSweeps, 4);
    EXPECT_EQ(scene.settings.baumgarte, 0.2);
    EXPECT_EQ(scene.settings.order, engine::Order::pairs);
    EXPECT_EQ(read("[solver]\npreset = 'seed'\nsubsteps = 8\n" + kBall).settings.maxSubsteps, 8);
}

TEST(Reader, ReadsAFastSolver) {
    const SceneDescription scene =
        read("[solver]\npreset = 'fast'\nlanes = false\nthreads = 3\n" + kBall);
    EXPECT_EQ(scene.preset, "fast");
    EXPECT_EQ(scene.settings.sweeps, engine::Settings::fast().sweeps);
    EXPECT_LT(scene.settings.sweeps, engine::Settings::steady().sweeps);
    EXPECT_FALSE(scene.settings.lanes);
    EXPECT_EQ(scene.settings.threads, 3);
}

TEST(Reader, ReadsWhetherIslandsSleep) {
    EXPECT_FALSE(read(kBall).settings.sleeping);
    const SceneDescription scene = read("[solver]\nsleeping = true\nsleep_after = 2\n" + kBall);
    EXPECT_TRUE(scene.settings.sleeping);
    EXPECT_EQ(scene.settings.sleepAfter, 2.0);
}

TEST(Reader, PutsAnchorsInBodyAxes) {
    const SceneDescription scene =
        read(kBall +
             "quaternion = [0, 0, 0, 1]\n[[joint]]\ntype = 'ball'\na = 'world'\nb = 'ball'\n"
             "anchor = [1, 3, 0]\n[[joint]]\ntype = 'distance'\na = 'ball'\nb = 'world'\n"
             "anchor_b = [0, 5, 0]\n");
    EXPECT_EQ(scene.joints[0].def.a.index, -1);
    EXPECT_EQ(scene.joints[0].def.anchorA, Vec3(1, 3, 0));
    EXPECT_NEAR((scene.joints[0].def.anchorB - Vec3(-1, -1, 0)).norm(), 0.0, 1e-15);
    EXPECT_EQ(scene.joints[0].name, "world-ball");
    EXPECT_EQ(scene.joints[1].def.length, 3.0);
}

TEST(Reader, KeepsTheOrderOfTheFile) {
    const SceneDescription scene =
        read("[[repeat]]\ncount = 2\nbody = { name = 'a{i}', shape = { sphere = 1 } }\n" + kBall);
    EXPECT_EQ(scene.bodies[0].name, "a0");
    EXPECT_EQ(scene.bodies[2].name, "ball");
}

TEST(Repeat, MovesAndNames) {
    const SceneDescription scene = read(
        "[[repeat]]\ncount = 3\nstep = [1, 2, 0]\n"
        "body = { name = 'a{i}', shape = { sphere = 0.1 }, at = [5, 0, 0] }\n"
        "[[repeat]]\ncount = 2\nstep = [1, 2, 0]\n"
        "joint = { type = 'ball', a = 'a{i}', b = 'a{i+1}', anchor = [5.5, 1, 0] }\n");
    ASSERT_EQ(scene.bodies.size(), 3u);
    EXPECT_EQ(scene.bodies[2].def.pose.position, Vec3(7, 4, 0));
    ASSERT_EQ(scene.joints.size(), 2u);
    EXPECT_EQ(scene.joints[1].name, "a1-a2");
    EXPECT_EQ(scene.joints[1].def.anchorA, Vec3(0.5, 1, 0));
}

TEST(Repeat, NestsWithAShrinkingCount) {
    const SceneDescription scene = read(
        "[[repeat]]\ncount = 3\nstep = [0.5, 1, 0]\n[[repeat.repeat]]\ncount = 3\n"
        "count_step = -1\nstep = [1, 0, 0]\nbody = { name = 'a{i}.{j}', shape = { sphere = 0.1 } "
        "}\n");
    ASSERT_EQ(scene.bodies.size(), 6u);  // 3 + 2 + 1
    EXPECT_EQ(scene.bodies[4].name, "a1.1");
    EXPECT_EQ(scene.bodies[4].def.pose.position, Vec3(1.5, 1, 0));
}

TEST(Repeat, TurnsAboutAPoint) {
    const SceneDescription scene = read(
        "[[repeat]]\ncount = 2\nturn_step_deg = [0, 0, 90]\nabout = [1, 0, 0]\n"
        "body = { name = 'a{i}', shape = { sphere = 0.1 }, at = [3, 0, 0] }\n");
    const engine::Pose& pose = scene.bodies[1].def.pose;
    EXPECT_NEAR((pose.position - Vec3(1, 2, 0)).norm(), 0.0, 1e-15);
    EXPECT_NEAR((pose.rotation * Vec3(1, 0, 0) - Vec3(0, 1, 0)).norm(), 0.0, 1e-15);
}

TEST(Repeat, JitterComesFromTheSeedAlone) {
    const std::string text =
        "[[repeat]]\ncount = 100\njitter = [0.5, 0, 0.1]\n"
        "body = { name = 'a{i}', shape = { sphere = 0.1 } }\n";
    const SceneDescription one = read(text), same = read(text),
                           other = read(text, {"world.seed=2"});
    double widest = 0.0, mean = 0.0;
    for (int i = 0; i < 100; ++i) {
        const Vec3 p = one.bodies[i].def.pose.position;
        EXPECT_EQ(p, same.bodies[i].def.pose.position);
        EXPECT_EQ(p.y(), 0.0);
        EXPECT_LE(std::abs(p.z()), 0.1);
        widest = std::max(widest, std::abs(p.x()));
        mean += p.x() / 100;
    }
    EXPECT_GT(widest, 0.45);
    EXPECT_LE(widest, 0.5);
    EXPECT_NEAR(mean, 0.0, 0.1);  // 3.5 standard deviations of 0.5 / sqrt(3 * 100)
    EXPECT_NE(one.bodies[0].def.pose.position, other.bodies[0].def.pose.position);
}

TEST(Captions, MayHoldFormulas) {
    const SceneDescription scene = read(kBall + "[[section]]\ncaption = '$\\frac{v^2}{r}$ at \\$5'\n"
                                                "[[section]]\nat = 1\ncaption = '5 $'\n");
    EXPECT_EQ(scene.sections[0].caption, "v²/r at $5");
    EXPECT_EQ(scene.sections[0].formulaCaption.formulas.size(), 1u);
    EXPECT_EQ(scene.sections[0].formulaCaption.markup.at(0), "$\\frac{v^2}{r}$");
    EXPECT_EQ(scene.sections[1].caption, "5 $");
    EXPECT_TRUE(scene.sections[1].formulaCaption.line.empty());
    std::string many;
    for (int i = 0; i < 21; ++i) {
        many += "[[section]]\ncaption = '";
        for (int k = 0; k < 50; ++k) many += "$x$ ";
        many += "'\n";
    }
    EXPECT_TRUE(tells(errorsOf("format = 1\n" + kBall + many), "a.toml:47:1: ", "more than 1000 formulas in all"));
    const std::string text = "format = 1\n" + kBall;
    EXPECT_TRUE(tells(errorsOf(text + "[[section]]\ncaption = '$\\fra{a}$'\n"), "a.toml:7:1: ",
                      "formula, byte 2 of the caption: Undefined control sequence: \\fra"));
    EXPECT_TRUE(tells(errorsOf(text + "[[section]]\ncaption = \"$\\theta$\"\n"), "a.toml:7:1: ",
                      "formula, byte 2 of the caption: a tab, a line break or a control byte"));
}

TEST(Overrides, AreReadAsIfTheFileHadSaidSo) {
    const SceneDescription scene = read(kBall, {"world.hz=240", "title=a film", "body.ball.mass=5",
                                                "body.0.at=[1, 2, 3]", "world.hz=120"});
    EXPECT_EQ(scene.hz, 120);
    EXPECT_EQ(scene.title, "a film");
    EXPECT_EQ(scene.bodies[0].def.mass, 5.0);
    EXPECT_EQ(scene.bodies[0].def.pose.position, Vec3(1, 2, 3));
}

TEST(Overrides, AreReportedByTheOption) {
    const std::string text = "format = 1\n" + kBall;
    EXPECT_TRUE(tells(errorsOf(text, {"world.hzz=3"}),
                      "--set world.hzz=3: ", "unknown key 'hzz' in [world]; did you mean 'hz'?"));
    EXPECT_TRUE(tells(errorsOf(text, {"world.hz=fast"}),
                      "--set world.hz=fast: ", "hz is the text \"fast\""));
    EXPECT_TRUE(tells(errorsOf(text, {"world.hz"}), "--set world.hz: ", "KEY=VALUE"));
    EXPECT_TRUE(tells(errorsOf(text, {"body.bal.mass=1"}), "--set body.bal.mass=1: ", "no 'bal'"));
}

TEST(Files, AreRegularAndSmall) {
    const auto failure = [](const std::string& path) {
        try {
            readSceneFile(path);
        } catch (const SceneError& error) {
            return error.lines().at(0);
        }
        return std::string();
    };
    EXPECT_NE(failure("/").find("is a directory"), std::string::npos);
    EXPECT_NE(failure("/dev/zero").find("not a regular file"), std::string::npos);
    EXPECT_NE(failure("/no/such.toml").find("no such file"), std::string::npos);
    const std::string path = testing::TempDir() + "reader_test.toml";
    std::ofstream(path) << "format = 1\n" << kBall;
    EXPECT_EQ(loadScene(path).name, "reader_test");
    std::filesystem::remove(path);
}

TEST(Files, UnknownNamesListTheNearest) {
    try {
        loadScene("stakc");
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_NE(error.lines().at(0).find("did you mean 'stack'?"), std::string::npos);
    }
}

TEST(Nearest, CountsSwapsAsOneEdit) {
    EXPECT_EQ(editDistance("sweesp", "sweeps", 9), 1);
    EXPECT_EQ(editDistance("", "ab", 9), 2);
    EXPECT_EQ(editDistance("kitten", "sitting", 9), 3);
    EXPECT_EQ(editDistance("kitten", "sitting", 4), 3);
    EXPECT_EQ(editDistance("kitten", "sitting", 3), 3);
    EXPECT_EQ(editDistance("kitten", "sitting", 2), 2);
    EXPECT_EQ(editDistance("abcdefgh", "badcfehg", 5), 4);  // four swaps
    const std::vector<std::string> names = {"gravity", "hz"};
    EXPECT_EQ(nearest("gravty", names), "gravity");
    EXPECT_EQ(nearest("xyz", names), "");
    EXPECT_EQ(nearest("h", names), "");  // one edit, but of the only letter
    EXPECT_EQ(nearest("gz", names), "hz");
    EXPECT_EQ(nearest("", names), "");
}

TEST(Patterns, TakeStars) {
    EXPECT_TRUE(matches("box*", "box12"));
    EXPECT_TRUE(matches("*a*b", "xaayb"));
    EXPECT_FALSE(matches("box*", "bo"));
    EXPECT_TRUE(matchesAny("ball,box*", "box1"));
    EXPECT_FALSE(matchesAny("ball,box*", "bal"));
}

}  // namespace
}  // namespace demos::test
