/// Files made to exhaust the program: each is refused with one line, within seconds of processor
/// time and a bounded memory. Without the limits they take minutes or gigabytes.
#include <cmath>

#include "tests/demos/program.h"
#include "tests/support/text.h"

namespace demos::test {
namespace {

using support::repeated;

/// Processor time, which does not depend on what else the machine does; s.
constexpr rlim_t kMostSeconds = 8;
constexpr long kMostKiB = 700 * 1024;

class HostileFiles : public testing::Test {
protected:
    Ended read(const std::string& name, const std::string& text) {
        write(folder / name, text);
        Launch launch;
        launch.folder = folder.path();
        launch.arguments = {"sim", name, "--seconds", "0.1"};
        launch.beforeExec = [] {
            const rlimit limit{kMostSeconds, kMostSeconds};
            setrlimit(RLIMIT_CPU, &limit);
        };
        return run(launch);
    }

    void expectRefused(const std::string& name, const std::string& text, const std::string& part,
                       int code = 3) {
        const Ended ended = read(name, text);
        EXPECT_EQ(ended.signal, 0) << part;
        EXPECT_EQ(ended.code, code) << ended.err;
        EXPECT_LE(ended.errorLines(), 21) << ended.err;
        EXPECT_LT(ended.err.size(), 21u * 2200u);
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err.substr(0, 3000);
        EXPECT_LT(ended.peakKiB, kMostKiB) << part;
    }

    TemporaryFolder folder;
};

const std::string kHead = "format = 1\n";

std::string bodies(int count, const std::string& name = "a{i}") {
    return kHead + "[[repeat]]\ncount = " + std::to_string(count) + "\nbody = { name = '" + name +
           "', shape = { sphere = 0.1 }, at = ['i', 0, 0] }\n";
}

TEST_F(HostileFiles, AHullOfManyPoints) {
    std::string points;
    for (int i = 0; i < 400'000; ++i) {
        const double y = 1.0 - (2.0 * i + 1.0) / 400'000, r = std::sqrt(1.0 - y * y);
        points += "v " + std::to_string(r * std::cos(2.4 * i)) + " " + std::to_string(y) + " " +
                  std::to_string(r * std::sin(2.4 * i)) + "\n";
    }
    write(folder / "ball.obj", points);
    expectRefused("a.toml", kHead + "[[body]]\nname = 'b'\nshape = { hull = 'ball.obj' }\n",
                  "ball.obj has more than 256 corners");
}

TEST_F(HostileFiles, ExpectationsAboutEverything) {
    expectRefused("a.toml",
                  bodies(3000) + repeated("[[expect]]\nwhat = 'speed'\nbelow = 1\n", 20'000),
                  "20000 [[expect]]s; a scene should have at most 1000");
    expectRefused("b.toml", bodies(3000) + repeated("[[expect]]\nwhat = 'speed'\nbelow = 1\n", 900),
                  "watch too much: 1002000 bodies and joints");
}

TEST_F(HostileFiles, BodiesInOnePlace) {
    for (const char* count : {"1000", "10000"})
        expectRefused("a.toml",
                      kHead + "[[repeat]]\ncount = " + count +
                          "\nbody = { name = 'a{i}', shape = { box = [1, 1, 1] } }\n",
                      "more than 200000 contacts, or millions of pairs", 6);
}

TEST_F(HostileFiles, ForcesOnEverything) {
    expectRefused("a.toml",
                  bodies(10'000) +
                      "[[repeat]]\ncount = 10000\nforce = { type = 'constant', force "
                      "= [1, 0, 0] }\n",
                  "the forces up to this one act on more than a million bodies");
}

TEST_F(HostileFiles, EveryBodyAttractsEveryOtherAgainAndAgain) {
    std::string text = bodies(2000);
    for (int i = 0; i < 100; ++i) text += "[[force]]\ntype = 'n-body-gravity'\n";
    expectRefused("a.toml", text, "are between more bodies than one of 2000 bodies");
}

TEST_F(HostileFiles, ALineOfOpenBrackets) {
    expectRefused("a.toml", kHead + "a = 1 " + repeated("(=", 450'000) + "\n", "not TOML");
}

TEST_F(HostileFiles, TheSameFileAgainAndAgain) {
    write(folder / "part.toml", kHead);
    expectRefused("a.toml", kHead + "include = [" + repeated("'part.toml',", 600'000) + "]\n",
                  "include has 600000 files; it should have at most 1000");
}

/// A million triangles from 8 MB, built once for every scale.
TEST_F(HostileFiles, AMeshInManyScales) {
    write(folder / "flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + repeated("f 1 2 3\n", 300'000));
    std::string text = kHead;
    for (int i = 1; i < 30; ++i)
        text += "[[body]]\nname = 'b" + std::to_string(i) + "'\nfixed = true\nshape = { hull = 'flat.obj', scale = " +
                std::to_string(i) + " }\n";
    expectRefused("a.toml", text, "the shapes have more than 4 million triangles");
}

TEST_F(HostileFiles, AModelOfTooManyJointsAndParts) {
    std::string inside, connects, pulled;
    for (int i = 0; i < 5000; ++i) {
        const std::string number = std::to_string(i);
        inside += "<body name='b" + number + "'><joint name='j" + number + "'/><geom size='1'/></body>";
        pulled += "<joint joint='j" + number + "' coef='1'/>";
    }
    for (int i = 1; i < 20'000; ++i)
        connects += "<connect body1='b0' body2='b" + std::to_string(i % 4999 + 1) + "' anchor='0 0 0'/>";
    const std::string world = "<worldbody>" + inside + "</worldbody>";
    expectRefused("a.xml", "<mujoco>" + world + "<equality>" + connects + "</equality></mujoco>",
                  "the model makes 24999 joints; it should make at most 20000");
    expectRefused("b.xml",
                  "<mujoco><worldbody><body><freejoint/>" + repeated("<geom size='1'/>", 100'000) +
                      "</body></worldbody></mujoco>",
                  "a <body> has 100000 <geom>s that collide; it should have at most 1000");
    expectRefused("c.xml",
                  "<mujoco>" + world + "<tendon><fixed>" + repeated(pulled, 20) +
                      "<joint joint='none'/></fixed></tendon></mujoco>",
                  "no joint is called 'none'");
}

/// Each name may be a misspelt one of ten thousand.
TEST_F(HostileFiles, ManyUnknownNames) {
    const std::string name(50, 'b');
    std::string text = bodies(10'000, name + "{i}");
    for (int i = 0; i < 10'000; ++i)
        text += "[[force]]\ntype = 'constant'\nforce = [1, 0, 0]\non = '" + name + "x" +
                std::to_string(i) + "'\n";
    expectRefused("a.toml", text, "no body is called '" + name + "x0'");
}

TEST_F(HostileFiles, ManyUnknownNamesInAModel) {
    std::string inside, excludes;
    for (int i = 0; i < 9000; ++i)
        inside +=
            "<body name='" + std::string(50, 'b') + std::to_string(i) + "'><geom size='1'/></body>";
    for (int i = 0; i < 70'000; ++i)
        excludes +=
            "<exclude body1='" + std::string(50, 'b') + "x" + std::to_string(i) + "' body2='a'/>";
    expectRefused(
        "a.xml",
        "<mujoco><contact>" + excludes + "</contact><worldbody>" + inside + "</worldbody></mujoco>",
        "and 80 more");
}

TEST_F(HostileFiles, AMeshThatIsReadAgainAndAgain) {
    write(folder / "large.obj",
          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n#" + std::string(7'000'000, ' '));
    std::string meshes;
    for (int i = 0; i < 5000; ++i)
        meshes += "<mesh name='m" + std::to_string(i) + "' file='large.obj'/>";
    expectRefused(
        "a.xml",
        "<mujoco><asset>" + meshes + "</asset><worldbody><geom size='1'/></worldbody></mujoco>",
        "with it, more than 128 MiB are read; use fewer files");
}

/// 32 million words.
TEST_F(HostileFiles, ALineThatDoesNotEnd) {
    write(folder / "line.obj", "f " + repeated("1 ", 32'000'000));
    expectRefused("a.toml",
                  kHead + "[[body]]\nname = 'b'\nfixed = true\nshape = { mesh = 'line.obj' }\n",
                  "a face of more than 256 corners");
}

/// A path of a thousand points for each of ten thousand joints.
TEST_F(HostileFiles, RepeatedLists) {
    expectRefused("a.toml",
                  bodies(1) +
                      "[[repeat]]\ncount = 10000\njoint = { type = 'path', a = 'world', b = "
                      "'a0', points = [" +
                      repeated("[0, 0, 0], ", 1000) + "] }\n",
                  "more than 2000000 values in all bodies, joints and forces");
}

TEST_F(HostileFiles, PatternsOfStars) {
    expectRefused("a.toml",
                  bodies(10'000) + "[look]\ntrails = '" + std::string(7'000'000, '*') + "'\n",
                  "no body is called '" + std::string(64, '*') + "...'");
}

TEST_F(HostileFiles, ManyGroups) {
    std::string groups;
    for (int i = 0; i < 500'000; ++i) groups += "'g" + std::to_string(i) + "',";
    expectRefused(
        "a.toml",
        kHead + "[[body]]\nname = 'a'\nshape = { sphere = 1 }\ngroup = [" + groups + "]\n",
        "a list of 500000 texts; it should have at most 1000");
}

}  // namespace
}  // namespace demos::test
