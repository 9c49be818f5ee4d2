// [values], expressions in place of numbers, [[repeat]] three deep, and --set of all of them.

#include <gtest/gtest.h>

#include "tests/demos/reading.h"

namespace demos::test {
namespace {

/// A ball with an additional line.
std::string ball(const std::string& line) { return kBall + line + "\n"; }

TEST(Values, StandInAnyNumber) {
    const SceneDescription scene = read(
        "seconds = '2 * span'\n[values]\nspan = 1.5\nrate = '40 * span'\n[world]\nhz = 'rate'\n"
        "seed = 'rate + 1'\n[snapshot]\ntimes = [0, 'span']\nsize = ['4 * rate', 100]\n" +
        ball("mass = 'span ^ 2'\nvelocity = ['-span', 0, 1]"));
    EXPECT_EQ(scene.seconds, 3.0);
    EXPECT_EQ(scene.hz, 60);
    EXPECT_EQ(scene.seed, 61u);
    EXPECT_EQ(scene.snapshot.times, (std::vector<double>{0.0, 1.5}));
    EXPECT_EQ(scene.snapshot.width, 240);
    EXPECT_EQ(scene.bodies[0].def.mass, 2.25);
    EXPECT_EQ(scene.bodies[0].def.velocity, Vec3(-1.5, 0, 1));
}

TEST(Values, AreSetBeforeWhatIsMadeOfThem) {
    const std::string text =
        "[values]\nradius = 0.5\nwide = '4 * radius'\n" + ball("mass = 'wide'");
    EXPECT_EQ(read(text).bodies[0].def.mass, 2.0);
    EXPECT_EQ(read(text, {"values.radius=0.75"}).bodies[0].def.mass, 3.0);
    EXPECT_EQ(read(text, {"values.radius=1/8"}).bodies[0].def.mass, 0.5);
    EXPECT_EQ(read(text, {"body.ball.mass=3*wide"}).bodies[0].def.mass, 6.0);
    EXPECT_TRUE(tells(errorsOf("format = 1\n" + text, {"values.radios=1"}),
                      "--set values.radios=1: ", "no value 'radios'; did you mean 'radius'?"));
    EXPECT_TRUE(tells(errorsOf("format = 1\n" + text, {"values.radius=wide"}),
                      "--set values.radius=wide: ", "there is no value 'wide'"));
}

TEST(Values, AreOfEarlierOnesOnly) {
    const auto lines = errorsOf("format = 1\n[values]\na = 'b'\nb = 1\n" + ball("mass = 'a'"));
    ASSERT_EQ(lines.size(), 1u) << listed(lines);
    EXPECT_TRUE(tells(lines, "a.toml:3:5: ",
                      "there is no value 'b' yet; define it earlier in [values]"));
    EXPECT_TRUE(tells(errorsOf("format = 1\n[values]\na = 'a'\n" + kBall),
                      "a.toml:3:5: ", "there is no value 'a'; known are: pi"));
}

TEST(Values, HaveNamesOfTheirOwn) {
    EXPECT_TRUE(tells(errorsOf("format = 1\n[values]\npi = 3\n" + kBall),
                      "a.toml:3:1: ", "a value is called 'pi': this is a constant of expressions"));
    EXPECT_TRUE(tells(errorsOf("format = 1\n[values]\nA = 3\n" + kBall),
                      "a.toml:3:1: ", "a value is called 'A': it should be 1 to 32 of a-z 0-9 _"));
    EXPECT_TRUE(tells(errorsOf("format = 1\nvalues = 3\n" + kBall),
                      "a.toml:2:10: ", "[values] is 3; it should be a table"));
    EXPECT_TRUE(tells(errorsOf("format = 1\n[values]\na = [1]\n" + kBall),
                      "a.toml:3:5: ", "a is a list of 1; it should be a number"));
    const auto lines =
        errorsOf("format = 1\n[values]\n" + std::string(5000, 'v') + " = 1\n" + kBall);
    ASSERT_EQ(lines.size(), 1u) << listed(lines);
    EXPECT_TRUE(tells(lines, "a.toml:3:1: ",
                      "a value is called '" + std::string(64, 'v') + "...': it should be 1 to 32"));
    std::string many = "format = 1\n[values]\n";
    for (int i = 0; i < 1001; ++i) {
        many += 'v';
        many += std::to_string(i);
        many += " = 1\n";
    }
    EXPECT_TRUE(tells(errorsOf(many + kBall), "a.toml:1003:1: ", "more than 1000 values"));
}

TEST(Values, ThatAreWrongAreReportedWithWhatTheyAre) {
    EXPECT_TRUE(tells(errorsOf("format = 1\n" + ball("mass = '1 - 2'")), "a.toml:6:8: ",
                      "mass is the text \"1 - 2\" = -1; it should be a number from 1e-06"));
    EXPECT_TRUE(tells(errorsOf("format = 1\n[world]\nhz = '100 / 3'\n" + kBall), "a.toml:3:6: ",
                      "it should be a whole number from 10 to 100000 steps a second"));
    EXPECT_TRUE(tells(errorsOf("format = 1\n" + ball("mass = '1 / 0'")),
                      "a.toml:6:8: ", "mass is the text \"1 / 0\": a division by zero"));
    EXPECT_TRUE(tells(errorsOf("format = 1\n" + ball("velocity = [0, 'x', 0]")),
                      "a.toml:6:16: ", "velocity is the text \"x\": there is no value 'x'"));
}

TEST(RepeatExpressions, PutBodiesOnACircle) {
    const SceneDescription scene = read(
        "[values]\nradius = 3\n[[repeat]]\ncount = 4\nbody = { name = 'a{i}', shape = { sphere = "
        "'0.1 * (i + 1)' }, at = ['radius * cos(i * tau / n)', '0.5 + i', "
        "'radius * sin(i * tau / n)'], turn_deg = [0, '90 * i', 0] }\n");
    ASSERT_EQ(scene.bodies.size(), 4u);
    EXPECT_NEAR((scene.bodies[1].def.pose.position - Vec3(0, 1.5, 3)).norm(), 0.0, 1e-15);
    EXPECT_NEAR((scene.bodies[2].def.pose.position - Vec3(-3, 2.5, 0)).norm(), 0.0, 1e-15);
    EXPECT_EQ(scene.bodies[3].def.shape.radius, 0.4);
    const Vec3 turned = scene.bodies[1].def.pose.rotation * Vec3(1, 0, 0);
    EXPECT_NEAR((turned - Vec3(0, 0, -1)).norm(), 0.0, 1e-15);
}

const std::string kThreeDeep =
    "[[repeat]]\ncount = 2\nstep = [10, 0, 0]\n[[repeat.repeat]]\ncount = 'i + 1'\n"
    "step = [0, 10, 0]\n[[repeat.repeat.repeat]]\ncount = 'j + 2'\nstep = [0, 0, '1 + i']\n"
    "body = { name = 'b{i}.{j}.{k}.{100*i+10*j+k}', shape = { sphere = 0.1 }, "
    "at = ['ni', 'nj', 'nk + n'] }\n";

TEST(RepeatExpressions, NestThreeDeep) {
    const SceneDescription scene = read(kThreeDeep);
    ASSERT_EQ(scene.bodies.size(), 7u);  // i = 0: 2; i = 1: 2 + 3
    EXPECT_EQ(scene.bodies[0].name, "b0.0.0.0");
    EXPECT_EQ(scene.bodies[6].name, "b1.1.2.112");
    EXPECT_EQ(scene.bodies[6].def.pose.position, Vec3(2 + 10, 2 + 10, 3 + 3 + 4));
}

TEST(RepeatExpressions, MayHaveNoTurns) {
    const SceneDescription scene = read(kBall +
                                        "[[repeat]]\ncount = 3\n[[repeat.repeat]]\ncount = 'i'\n"
                                        "body = { name = 'a{i}.{j}', shape = { sphere = 0.1 } }\n");
    EXPECT_EQ(scene.bodies.size(), 4u);  // the ball, then 0 + 1 + 2
    EXPECT_TRUE(tells(
        errorsOf("format = 1\n" + kBall + "[[repeat]]\ncount = '1 - 2'\nbody = { name = 'a' }\n"),
        "a.toml:7:9: ", "count is the text \"1 - 2\" = -1; it should be a whole"));
}

TEST(RepeatExpressions, InNamesAreWhole) {
    const auto told = [](const std::string& name) {
        const auto lines = errorsOf("format = 1\n[[repeat]]\ncount = 2\nbody = { name = '" + name +
                                    "', shape = { sphere = 0.1 } }\n");
        EXPECT_EQ(lines.size(), 1u) << listed(lines);
        return lines;
    };
    EXPECT_TRUE(tells(told("a{q}"), "a.toml:4:10: ", "{q} in a name: there is no value 'q'"));
    EXPECT_TRUE(tells(told("a{i}.{(i+1)/2}"), "a.toml:4:10: ",
                      "{(i+1)/2} in a name is 0.5; it should be a whole number"));
    EXPECT_TRUE(tells(told("a{}"), "a.toml:4:10: ", "{} in a name: an empty expression"));
    EXPECT_TRUE(tells(told("a{j}"), "a.toml:4:10: ", "{j} in a name: j is not defined at"));
    EXPECT_TRUE(tells(told("a{i+1e10}"), "a.toml:4:10: ", "should be from -1e9 to 1e9"));
    // Outside a [[repeat]], braces are ordinary characters.
    EXPECT_EQ(read("[[body]]\nname = 'a{q}'\nshape = { sphere = 1 }\n").bodies[0].name, "a{q}");
}

TEST(RepeatExpressions, InNamesOfOtherBodiesAreReportedThere) {
    const std::string repeat = "format = 1\n" + kBall + "[[repeat]]\ncount = 2\n";
    const auto joint = errorsOf(repeat + "joint = { type = 'ball', a = 'world', b = 'ball{(i+1)/4}', "
                                         "anchor = [0, 0, 0] }\n");
    ASSERT_EQ(joint.size(), 1u) << listed(joint);
    EXPECT_TRUE(tells(joint, "a.toml:8:39: ", "{(i+1)/4} in a name is 0.25; it should be a whole"))
        << listed(joint);
    const auto force =
        errorsOf(repeat + "force = { type = 'wind', velocity = [1, 0, 0], on = 'b{x}*' }\n");
    ASSERT_EQ(force.size(), 1u) << listed(force);
    EXPECT_TRUE(tells(force, "a.toml:8:48: ", "{x} in a name: there is no value 'x'"));
}

TEST(RepeatExpressions, AreReportedOnce) {
    const auto lines = errorsOf(
        "format = 1\n[[repeat]]\ncount = 50\nbody = { name = 'a{i}', shape = { sphere = 'i' } }\n");
    ASSERT_EQ(lines.size(), 1u) << listed(lines);
    EXPECT_TRUE(tells(lines, "a.toml:4:44: ", "sphere is the text \"i\" = 0; it should be"));
}

TEST(SetOption, ReachesIntoRepeatsByNumberAndByName) {
    const auto count = [](const std::string& option) {
        return read(kThreeDeep, {option}).bodies.size();
    };
    EXPECT_EQ(count("repeat.0.count=1"), 2u);
    EXPECT_EQ(count("repeat.0.repeat.0.count=1"), 4u);
    const std::string boxes =
        "[[repeat]]\ncount = 2\nbody = { name = 'a{i}.x', shape = { sphere = 0.1 } }\n" + kBall;
    EXPECT_EQ(read(boxes, {"repeat.\"a{i}.x\".count=3"}).bodies.size(), 4u);
    EXPECT_EQ(read(boxes, {"repeat.0.body.shape.sphere=0.2"}).bodies[1].def.shape.radius, 0.2);
    EXPECT_EQ(read(boxes, {"repeat.0.body.mass=i + 1"}).bodies[1].def.mass, 2.0);
    EXPECT_TRUE(tells(errorsOf("format = 1\n" + boxes, {"repeat.0.cont=3"}),
                      "--set repeat.0.cont=3: ",
                      "unknown key 'cont' in a [[repeat]]; did you "
                      "mean 'count'?"));
    EXPECT_TRUE(tells(errorsOf("format = 1\n" + boxes, {"repeat.1.count=3"}),
                      "--set repeat.1.count=3: ", "there is no '1' in [[repeat]]; it has 1 table"));
    const auto none = errorsOf("format = 1\n" + kBall, {"repeat.0.count=5"});
    ASSERT_EQ(none.size(), 1u) << listed(none);
    EXPECT_TRUE(tells(none, "--set repeat.0.count=5: ", "there is no '0' in this scene; a list"));
    EXPECT_TRUE(tells(errorsOf("format = 1\n" + boxes, {"include=\"a.toml\""}),
                      "--set include=", "files are included before --set"));
}

const std::string kSixBoxes =
    "[[repeat]]\ncount = 4\nstep = [0, 1, 0]\nbody = { name = 'box{i}', shape = { sphere = 0.1 } }\n"
    "[[body]]\nname = 'boxing'\nshape = { sphere = 0.1 }\n"
    "[[body]]\nname = 'box-a'\nshape = { sphere = 0.1 }\n"
    "[[body]]\nname = 'box.b'\nshape = { sphere = 0.1 }\n"
    "[[repeat]]\ncount = 3\n"
    "joint = { type = 'ball', a = 'box{i}', b = 'box{i+1}', anchor = [0, 'i', 0] }\n";

/// Bodies of kSixBoxes that this option gives 5 kg.
std::vector<std::string> heavyBodies(const std::string& option) {
    std::vector<std::string> names;
    for (const BodyDescription& body : read(kSixBoxes, {option}).bodies)
        if (body.def.mass == 5.0) names.push_back(body.name);
    return names;
}

TEST(SetOption, ReachesOneOfManyBodies) {
    using Names = std::vector<std::string>;
    EXPECT_EQ(heavyBodies("body.box[0].mass=5"), Names{"box0"});
    EXPECT_EQ(heavyBodies("body.box[3].mass=5"), Names{"box3"});
    EXPECT_EQ(heavyBodies("body.box[4].mass=5"), Names{"box-a"});
    EXPECT_EQ(heavyBodies("body.box[5].mass=5"), Names{"box.b"});
    EXPECT_EQ(heavyBodies("body.boxing[0].mass=5"), Names{"boxing"});
    EXPECT_EQ(heavyBodies("body.\"box.\"[0].mass=5"), Names{"box.b"});
    EXPECT_EQ(heavyBodies("body[0].mass=5"), Names{"boxing"});
    EXPECT_EQ(heavyBodies("body.1.mass=5"), Names{"box-a"});
    EXPECT_EQ(heavyBodies("repeat[0].body.mass=5").size(), 4u);
}

TEST(SetOption, MovesAndNamesOneTurnOfARepeat) {
    const SceneDescription scene =
        read(kSixBoxes, {"body.box[2].at=[1, 'i', 0]", "body.box[2].mass=i + 1",
                         "body.box[2].shape.sphere=0.2", "joint.box[1].break_at=7"});
    EXPECT_EQ(scene.bodies[2].def.pose.position, Vec3(1, 4, 0));
    EXPECT_EQ(scene.bodies[2].def.mass, 3.0);
    EXPECT_EQ(scene.bodies[2].def.shape.radius, 0.2);
    EXPECT_EQ(scene.bodies[1].def.shape.radius, 0.1);
    EXPECT_EQ(scene.bodies[3].def.pose.position, Vec3(0, 3, 0));
    EXPECT_EQ(scene.joints[1].def.breakForce, 7.0);
    EXPECT_EQ(scene.joints[2].def.breakForce, engine::kUnlimited);
}

TEST(SetOption, SaysHowManyThereAre) {
    const auto refusal = [](const std::string& option) {
        const auto lines = errorsOf("format = 1\n" + kSixBoxes, {option});
        return lines.size() == 1 ? lines[0] : listed(lines);
    };
    EXPECT_EQ(refusal("body.box[6].mass=5"),
              "--set body.box[6].mass=5: the names of 6 bodies begin with 'box'; the index counts "
              "from 0 and should be at most 5");
    EXPECT_EQ(refusal("body.boxing[1].mass=5"),
              "--set body.boxing[1].mass=5: the names of 1 body begin with 'boxing'; the index "
              "counts from 0 and should be at most 0");
    EXPECT_EQ(refusal("body.boxin[1].mass=5"),
              "--set body.boxin[1].mass=5: no body has a name that begins with 'boxin'; did you "
              "mean 'boxing'?");
    EXPECT_EQ(refusal("body.box[1].mas=5"),
              "--set body.box[1].mas=5: unknown key 'mas' in a [[body]]; did you mean 'mass'?");
    EXPECT_NE(refusal("force.wind[0].drag=1").find("no force has a name"), std::string::npos);
    for (const char* option :
         {"body.box[1]=5", "body.box[-1].mass=5", "body.box[].mass=5", "body.[1].mass=5",
          "body.box[99999999999999999999].mass=5", "body.box[1][1].mass=5", "body[9].mass=5"})
        EXPECT_EQ(refusal(option).find('\n'), std::string::npos) << option << refusal(option);
}

}  // namespace
}  // namespace demos::test
