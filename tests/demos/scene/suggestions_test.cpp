// Words of other programs, numbers with units and files that are not TOML are answered with what
// would be right.

#include <gtest/gtest.h>

#include "demos/scene/toml_mend.h"
#include "demos/text/nearest.h"
#include "demos/text/synonyms.h"
#include "tests/demos/reading.h"

namespace demos::test {
namespace {

using WordList = std::vector<std::string>;

TEST(Synonyms, LeadToTheWordOfTheFormat) {
    const WordList shapes = {"sphere", "box", "hull"}, body = {"name", "at", "turn_deg", "colour", "mass"};
    EXPECT_EQ(nearest("ball", shapes), "sphere");
    EXPECT_EQ(nearest("Cube", shapes), "box");
    EXPECT_EQ(nearest("position", body), "at");
    EXPECT_EQ(nearest("rotation", body), "turn_deg");
    EXPECT_EQ(nearest("color", body), "colour");
    EXPECT_EQ(nearest("weight", body), "mass");
    EXPECT_EQ(nearest("revolute", WordList{"ball", "hinge"}), "hinge");
}

TEST(Synonyms, AreOfferedOnlyIfTheNameIsThere) {
    EXPECT_EQ(nearest("weight", WordList{"density", "shape"}), "");
    EXPECT_EQ(nearest("position", WordList{"from", "look_at"}), "from");  // a camera's
}

TEST(Synonyms, MayBeWrittenInAnyWay) {
    for (const char* word : {"lookAt", "look-at", "LOOK_AT", "look at", "target"})
        EXPECT_EQ(nearest(word, WordList{"from", "look_at"}), "look_at") << word;
    EXPECT_TRUE(sameLetters("turnDeg", "turn_deg"));
    EXPECT_FALSE(sameLetters("turn", "turn_deg"));
}

TEST(Nearest, OfAShortWordIsOneEditAway) {
    EXPECT_EQ(nearest("bulk", WordList{"hull"}), "");   // two of four letters
    EXPECT_EQ(nearest("hulk", WordList{"hull"}), "hull");
    EXPECT_EQ(nearest("spehere", WordList{"sphere"}), "sphere");
    EXPECT_EQ(nearest("swee", WordList{"seed", "sweeps"}), "sweeps");  // its beginning
    EXPECT_EQ(nearest("sw", WordList{"seed", "sweeps"}), "");
}

struct Answer {
    const char* what;
    std::string text;  // after "format = 1\n"
    const char* place;
    const char* message;
};
std::ostream& operator<<(std::ostream& out, const Answer& answer) { return out << answer.what; }

class Answers : public testing::TestWithParam<Answer> {};

TEST_P(Answers, NameTheMend) {
    const Answer& answer = GetParam();
    const std::vector<std::string> lines = errorsOf("format = 1\n" + answer.text);
    EXPECT_TRUE(tells(lines, std::string("a.toml:") + answer.place + ": ", answer.message))
        << answer.what << "\n"
        << listed(lines);
}

INSTANTIATE_TEST_SUITE_P(
    Words, Answers,
    testing::Values(
        Answer{"shape as a text", "[[body]]\nname = 'a'\nshape = 'ball'\n", "4:9",
               "shape is the text \"ball\"; it should be a table like { sphere = 0.5 }"},
        Answer{"unknown shape as a text", "[[body]]\nname = 'a'\nshape = 'qqqqq'\n", "4:9",
               "it should be a table like { sphere = 0.5 }, or sphere, box"},
        Answer{"shape", "[[body]]\nname = 'a'\nshape = { cube = 1 }\n", "4:11",
               "unknown key 'cube' in a shape; did you mean 'box'?"},
        Answer{"key", kBall + "position = [0, 1, 0]\n", "6:1", "did you mean 'at'?"},
        Answer{"key of another table", kBall + "friction = 0.5\n", "6:1",
               "unknown key 'friction' in a [[body]]; it is a key of a [[material]]"},
        Answer{"like a key of another table", kBall + "bounce = 0.5\n", "6:1",
               "did you mean 'restitution' of a [[material]]?"},
        Answer{"double brackets", kBall + "[[world]]\nhz = 60\n", "6:1",
               "[world] is a list of 1; it should be a table, in single brackets"},
        Answer{"key of nothing", kBall + "qqqqqqq = 0.5\n", "6:1", "; known are: name, "},
        Answer{"joint", kBall + "[[joint]]\ntype = 'revolute'\na = 'world'\nb = 'ball'\n", "7:8",
               "did you mean 'hinge'?"},
        Answer{"table", kBall + "[camara]\nfrom = [1, 2, 3]\n", "6:2", "did you mean 'camera'?"}));

INSTANTIATE_TEST_SUITE_P(
    Units, Answers,
    testing::Values(
        Answer{"density", kBall + "density = '7800 kg'\n", "6:11",
               "density is the text \"7800 kg\"; it should be the number alone, in kg/m^3"},
        Answer{"in a vector", kBall + "velocity = ['2.5 m/s', 0, 0]\n", "6:13",
               "it should be the number alone, in m/s"},
        Answer{"without a space", kBall + "turn_deg = [0, 0, '45deg']\n", "6:19",
               "the number alone, in deg"},
        Answer{"a sign", kBall + "turn_deg = [0, 0, '45°']\n", "6:19", "the number alone, in deg"},
        Answer{"whole", kBall + "[world]\nhz = '60 Hz'\n", "7:6",
               "the number alone, in steps a second"},
        Answer{"no unit of its own", "[[material]]\nname = 'm'\nfriction = '50 %'\n" + kBall, "4:12",
               "it should be the number alone, in SI units"},
        Answer{"no unit but a name", kBall + "density = '2 * kg'\n", "6:11",
               "there is no value 'kg'"},
        Answer{"a name that ends in a digit", kBall + "density = 'x2 kg'\n", "6:11",
               "there is no value 'x2'"}));

INSTANTIATE_TEST_SUITE_P(
    Toml, Answers,
    testing::Values(
        Answer{"text without quotes", "[[body]]\nname = 'a'\nshape = box\n", "4:9",
               "; texts and expressions are written in quotes: \"box\""},
        Answer{"a name with a bracket", "[[repeat]]\nbody = { name = box{i}, fixed = true }\n",
               "3:17", "in quotes: \"box{i}\""},
        Answer{"in a list", kBall + "turn_deg = [0, lift / 2, 0]\n", "6:16",
               "in quotes: \"lift / 2\""},
        Answer{"a unit", kBall + "density = 7800 kg # of steel\n", "6:16",
               "without a unit; an expression is written in quotes: \"7800 kg\""},
        Answer{"a sum", kBall + "mass = 2 * 3\n", "6:10", "in quotes: \"2 * 3\""},
        Answer{"True", kBall + "fixed = True\n", "6:9", "; write true"},
        Answer{"no", kBall + "fixed = no\n", "6:10", "; write false"},
        Answer{"a colon", kBall + "mass: 3\n", "6:5", "; write = after a key, not :"},
        Answer{"round brackets", kBall + "turn_deg = (0, 0, 1)\n", "6:12",
               "; a list is written in brackets: [1, 2, 3]"},
        Answer{"a comma", kBall + "mass = 1,5\n", "6:9", "; decimals have a point: 1.5"},
        Answer{"a key twice", kBall + "mass = 1\nmass = 2\n", "7:8", "; write each key once"},
        Answer{"one bracket", "[body]\nname = 'a'\n[body]\nname = 'b'\n", "4:1",
               "; write [[body]] over each of them"},
        Answer{"a table twice", "[world]\nhz = 60\n[world]\nhz = 30\n", "4:1",
               "; write [world] once"}));

TEST(TomlMend, LeavesGoodValuesAlone) {
    for (const char* line :
         {"a = [1, -2.5e3, +4, 0x1f, 1_000, inf]", "at = 1979-05-27T07:32:00Z", "b = \"x, y z\"",
          "c = { d = 'e', f = true } # a comment, x = y", "[[body]]", "x = 'it''s'", ""})
        EXPECT_EQ(tomlMend(line, 1, "an error"), "") << line;
}

std::vector<std::string> refusedSetting(const std::string& setting) {
    const std::string boxes =
        "[[repeat]]\ncount = 3\nbody = { name = 'box{i}', shape = { sphere = 1 } }\n";
    return errorsOf("format = 1\n" + kFloor + kBall + boxes, {setting});
}

TEST(Overrides, SuggestNamesAndKeys) {
    const auto answers = [](const std::string& setting, const std::string& text) {
        EXPECT_TRUE(tells(refusedSetting(setting), "--set " + setting + ": ", text))
            << listed(refusedSetting(setting));
    };
    answers("body.bal.mass=3", "there is no 'bal' in [[body]]; did you mean 'ball'?");
    answers("body.qqqqq.mass=3", "there is no 'qqqqq' in [[body]]; known are: floor, ball");
    answers("body.ball.mas=3", "did you mean 'mass'?");
    answers("body.ball.weight=3", "did you mean 'mass'?");
    answers("body.7.mass=3", "it has 2 tables, counted from 0");
    answers("body.box1.mass=3", "what a [[repeat]] makes is reached like body.box[0]");
    answers("bodies.ball.mass=3", "did you mean 'body'?");
    answers("repeat.bx{i}.count=4", "there is no 'bx{i}' in [[repeat]]; did you mean 'box{i}'?");
}

}  // namespace
}  // namespace demos::test
