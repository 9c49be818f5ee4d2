// @{...} in a slide's text: which number it names, and what is invalid.

#include "demos/slides/numbers.h"

#include <gtest/gtest.h>

namespace demos::test {
namespace {

/// "run group of field digits" of the first number.
std::string asked(const std::string& text) {
    const NumberName name = numberedText(text).numbers.at(0);
    return std::to_string(name.run) + " " + name.group + " '" + name.of + "' '" + name.field +
           "' " + std::to_string(name.digits);
}

/// "byte: what", or "" if it is accepted.
std::string mistake(const std::string& text) {
    try {
        numberedText(text);
    } catch (const NumberError& error) {
        return std::to_string(error.at()) + ": " + error.what();
    }
    return "";
}

TEST(Numbers, AreCutOutOfTheirText) {
    const NumberedText text = numberedText("sinks @{penetration}, not @{2.drift:4}");
    EXPECT_EQ(text.words, (std::vector<std::string>{"sinks ", ", not ", ""}));
    EXPECT_EQ(text.places, (std::vector<std::size_t>{6, 26}));
    EXPECT_EQ(text.numbers.size(), 2u);
    EXPECT_EQ(numberedText("").words, std::vector<std::string>{""});
}

TEST(Numbers, AreCalledByTheirNames) {
    EXPECT_EQ(asked("@{penetration}"), "1 measure '' 'penetration' 3");
    EXPECT_EQ(asked("@{2.drift:4}"), "2 measure '' 'drift' 4");
    EXPECT_EQ(asked("@{expect.12}"), "1 expect '12' '' 3");
    EXPECT_EQ(asked("@{body.box3.velocity}"), "1 body 'box3' 'velocity' 3");
    EXPECT_EQ(asked("@{3.body.a.b{i}.speed:1}"), "3 body 'a.b{i}' 'speed' 1");
    EXPECT_EQ(asked("@{joint.rod.separation}"), "1 joint 'rod' 'separation' 3");
    EXPECT_EQ(asked("@{contacts.largest}"), "1 contacts '' 'largest' 3");
    EXPECT_EQ(asked("@{run.hash}"), "1 run '' 'hash' 3");
}

TEST(Numbers, KeepTheZerosOfDigitsThatAreAskedFor) {
    EXPECT_EQ(numberedText("@{drift:4}").numbers[0].zeros, Zeros::kept);
    EXPECT_EQ(numberedText("@{drift}").numbers[0].zeros, Zeros::dropped);
}

TEST(Numbers, AreHiddenByLetters) {
    const std::string text = "a @{body.$x.speed} b @{drift}";
    EXPECT_EQ(maskedNumbers(text, numberedText(text), '.'), "a ................ b ........");
}

TEST(Numbers, AreNotWhereABackslashIs) {
    EXPECT_EQ(numberedText("a \\@{b} @ { @x").words, std::vector<std::string>{"a \\@{b} @ { @x"});
    EXPECT_EQ(asked("\\\\@{drift}"), "1 measure '' 'drift' 3");
}

TEST(Numbers, SayWhatIsWrongAndWhere) {
    EXPECT_EQ(mistake("a @{penetraton}"),
              "2: no number is called 'penetraton'; did you mean 'penetration'?");
    EXPECT_EQ(mistake("@{pen}"), "0: no number is called 'pen'; did you mean 'penetration'?");
    EXPECT_EQ(mistake("@{bodies.a.speed}").substr(0, 60),
              "0: no number is called 'bodies.a.speed'; known are: drift, s");
    EXPECT_EQ(mistake("@{body.a.velocty}"), "0: a body has no 'velocty'; did you mean 'velocity'?");
    EXPECT_EQ(mistake("@{joint.a.x}"),
              "0: a joint has no 'x'; known are: impulse, force, separation");
    EXPECT_EQ(mistake("@{contacts.sum}"),
              "0: 'contacts' has no 'sum'; known are: impulse, points, largest");
    EXPECT_EQ(mistake("@{body.speed}"),
              "0: 'body.speed' has no field; write @{body.NAME.position}");
    EXPECT_EQ(mistake("@{expect.0}"), "0: expectation '0'; they count from 1, as in @{expect.1}");
    EXPECT_EQ(mistake("@{drift:0}"),
              "0: '0' significant digits; it should be a whole number from 1 to 9");
    EXPECT_EQ(mistake("@{0.drift}"), "0: run 0; it should be from 1 to 1000");
    EXPECT_EQ(mistake("ab\n@{drift\n}"),
              "3: '@{drift\n}' has no } in its line; write \\@{ for an @ and a brace");
    EXPECT_EQ(mistake("@{}").substr(0, 27), "0: no number is called ''; ");
}

TEST(Numbers, SurviveAnything) {
    EXPECT_EQ(numberedText(std::string(1 << 20, '@')).numbers.size(), 0u);
    EXPECT_NE(mistake("@{" + std::string(1 << 20, '{')), "");
    EXPECT_NE(mistake("@{99999999999999999999.drift}"), "");
    EXPECT_NE(mistake(std::string("@{\0}", 4)), "");
    EXPECT_NE(mistake("@{\xff.\xfe}"), "");
}

}  // namespace
}  // namespace demos::test
