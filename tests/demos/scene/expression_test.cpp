// The values of expressions, and the errors in them.

#include "demos/scene/expression.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demos::test {
namespace {

Turns oneRepeat(int i, int n) {
    Turns turns;
    turns.depth = 1;
    turns.index[0] = i;
    turns.count[0] = n;
    return turns;
}

struct Worth {
    const char* text;
    double value;  // exact: no rounding beyond that of IEEE 754
};

class Worths : public testing::TestWithParam<Worth> {};

TEST_P(Worths, AreExact) {
    Expressions expressions;
    expressions.define("radius", 0.5);
    const Evaluated result = expressions.evaluate(GetParam().text, oneRepeat(3, 10));
    ASSERT_TRUE(result.value.has_value()) << GetParam().text << ": " << result.wrong;
    EXPECT_EQ(*result.value, GetParam().value) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Expressions, Worths,
    testing::Values(Worth{"1 + 2 * 3", 7}, Worth{"(1 + 2) * 3", 9}, Worth{"7 / 2", 3.5},
                    Worth{"10 - 3 - 2", 5}, Worth{"-2^2", -4}, Worth{"(-2)^3", -8},
                    Worth{"2^3^2", 512}, Worth{"2^-2", 0.25}, Worth{"+.5e1", 5},
                    Worth{"radius * i", 1.5}, Worth{"n", 10}, Worth{"ni - 1", 9},
                    Worth{"min(3, 1, 2)", 1}, Worth{"max(3, 1, 2)", 3}, Worth{"abs(-3)", 3},
                    Worth{"floor(-1.5)", -2}, Worth{"ceil(-1.5)", -1}, Worth{"round(2.5)", 3},
                    Worth{"round(-2.5)", -3}, Worth{"round(0.49999999999999994)", 0},
                    Worth{"mod(-1, 3)", 2}, Worth{"mod(7.5, 2)", 1.5}, Worth{"sqrt(2.25)", 1.5},
                    Worth{"sin(0)", 0}, Worth{"cos(0)", 1}, Worth{"atan2(0, 1)", 0},
                    Worth{"asin(0)", 0}, Worth{"-0 * 1", 0}, Worth{"tau - 2 * pi", 0}));

TEST(Expressions, KnowTrigonometry) {
    Expressions expressions;
    // 1e-14: a few roundings of numbers near 1.
    for (const char* text :
         {"sin(0.7)^2 + cos(0.7)^2 - 1", "tan(0.7) - sin(0.7) / cos(0.7)", "asin(sin(0.7)) - 0.7",
          "acos(cos(0.7)) - 0.7", "atan(tan(0.7)) - 0.7", "atan2(3, -3) - 0.75 * pi"}) {
        const Evaluated result = expressions.evaluate(text, {});
        ASSERT_TRUE(result.value.has_value()) << text << ": " << result.wrong;
        EXPECT_NEAR(*result.value, 0.0, 1e-14) << text;
    }
}

TEST(Expressions, HashIsSpreadEvenlyAndTheSameEverywhere) {
    Expressions expressions;
    double sum = 0.0, least = 1.0, most = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const double x = *expressions.evaluate("hash(i)", oneRepeat(i, 1000)).value;
        sum += x, least = std::min(least, x), most = std::max(most, x);
    }
    EXPECT_NEAR(sum / 1000, 0.5, 0.04);  // four standard deviations of 1 / sqrt(12 * 1000)
    EXPECT_GE(least, 0.0);
    EXPECT_LT(least, 0.01);
    EXPECT_GT(most, 0.99);
    EXPECT_LT(most, 1.0);
    EXPECT_EQ(*expressions.evaluate("hash(3)", {}).value, 0.46853069018951665);
    EXPECT_NE(*expressions.evaluate("hash(3, 4)", {}).value,
              *expressions.evaluate("hash(4, 3)", {}).value);
    EXPECT_EQ(*expressions.evaluate("hash(-0)", {}).value,
              *expressions.evaluate("hash(0)", {}).value);
}

struct Mistake {
    std::string text;
    const char* wrong;
};

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreReported) {
    Expressions expressions;
    expressions.define("radius", 0.5);
    const Evaluated result = expressions.evaluate(GetParam().text, oneRepeat(3, 10));
    EXPECT_FALSE(result.value.has_value()) << GetParam().text;
    EXPECT_NE(result.wrong.find(GetParam().wrong), std::string::npos)
        << GetParam().text << ": " << result.wrong;
}

INSTANTIATE_TEST_SUITE_P(
    Expressions, Mistakes,
    testing::Values(
        Mistake{"1 / 0", "a division by zero"}, Mistake{"1 / (i - 3)", "a division by zero"},
        Mistake{"mod(1, 0)", "a division by zero"}, Mistake{"0^-1", "a division by zero"},
        Mistake{"radios * 2", "there is no value 'radios'; did you mean 'radius'?"},
        Mistake{"sine(1)", "there is no function 'sine'; did you mean 'sin'?"},
        Mistake{"pow(2, 3)", "there is no function 'pow'"},
        Mistake{"exp(1)", "there is no function 'exp'"},
        Mistake{"radius(1)", "there is no function 'radius'"},
        Mistake{"sin", "sin is a function; write sin(x)"},
        Mistake{"j + 1", "j is not defined at [[repeat]] depth 1; it needs depth 2"},
        Mistake{"nk", "it needs depth 3"}, Mistake{"1, 2", "two numbers; it should be one"},
        Mistake{"1 +", "it ends too early"}, Mistake{"(1", "a '(' without its ')'"},
        Mistake{"1)", "')' is not expected at character 2"},
        Mistake{"3 4", "'4' is not expected at character 3"},
        Mistake{"1e400", "a number that cannot be read at character 1"},
        Mistake{"sin(1, 2)", "more arguments than sin() takes"},
        Mistake{"atan2(1)", "fewer arguments than atan2() takes"},
        Mistake{"min()", "fewer arguments than min() takes"},
        Mistake{"sin(1e6)", "it should be from -100000 to 100000 rad"},
        Mistake{"asin(2)", "asin(2); it should be from -1 to 1"},
        Mistake{"acos(-1.5)", "acos(-1.5); it should be from -1 to 1"},
        Mistake{"sqrt(-1)", "it should not be below 0"},
        Mistake{"2^0.5", "an exponent of 0.5; it should be a whole number"},
        Mistake{"2^1e9", "it should be a whole number from -1000 to 1000"},
        Mistake{"1e308 * 10", "too large for a number"}, Mistake{"", "an empty expression"},
        Mistake{"i = 3", "'=' is not expected at character 3"},
        Mistake{"\"a\"", "'\"' is not expected at character 1"},
        Mistake{"i ? 1 : 2", "'?' is not expected"}, Mistake{"\x1b[2J", "is not expected"},
        Mistake{std::string(201, '1'), "201 characters; it should be at most 200"},
        Mistake{std::string(200, '('), "it ends too early"}));

TEST(Expressions, AreAtMostSoManyInAScene) {
    Expressions expressions;
    std::string wrong;
    for (int i = 0; i < 300'001; ++i) wrong = expressions.evaluate("", {}).wrong;
    EXPECT_EQ(wrong, "more than 300000 expressions in a scene");
}

TEST(Expressions, NamesAreLettersThatMeanNothingYet) {
    const Expressions expressions;
    EXPECT_EQ(expressions.whyNoName("radius_2"), "");
    for (const char* name : {"", "Radius", "2r", "_r", "a-b", "r\u00e9"})
        EXPECT_NE(expressions.whyNoName(name).find("a-z 0-9 _"), std::string::npos) << name;
    EXPECT_NE(expressions.whyNoName("pi").find("constant"), std::string::npos);
    EXPECT_NE(expressions.whyNoName("hash").find("function"), std::string::npos);
    EXPECT_NE(expressions.whyNoName("nk").find("[[repeat]]"), std::string::npos);
    EXPECT_NE(expressions.whyNoName(std::string(33, 'a')), "");
}

}  // namespace
}  // namespace demos::test
