// A scene file's bytes: not text, too much for the parser, and how they are shown in messages.

#include <gtest/gtest.h>

#include "tests/demos/reading.h"

namespace demos::test {
namespace {

TEST(Reader, RefusesBytesThatAreNoText) {
    EXPECT_FALSE(errorsOf(std::string("format = 1\n\0", 12)).empty());
    EXPECT_FALSE(errorsOf(std::string("\xff\xfe"
                                      "f\0o\0",
                                      6))
                     .empty());
    EXPECT_FALSE(errorsOf("seconds = 1e999\n" + kBall).empty());
}

TEST(Reader, RefusesWhatWouldExhaustTheParser) {
    const std::string deep(100'000, '[');
    EXPECT_TRUE(tells(errorsOf("a = " + deep), "a.toml:1:", "nested deeper than 32"));
    std::string dotted = "a";
    for (int i = 0; i < 100'000; ++i) dotted += ".a";
    EXPECT_TRUE(tells(errorsOf(dotted + " = 1"), "a.toml:1:", "more than 32 parts"));
    std::string many = "a = [";
    for (int i = 0; i < 1'000'001; ++i) many += "1,";
    EXPECT_TRUE(tells(errorsOf(many + "]"), "a.toml:1:", "more than a million values"));
    EXPECT_TRUE(tells(errorsOf(std::string(9u << 20, ' ')), "a.toml: ", "8 MiB"));
}

TEST(Reader, RefusesLettersBeyondAsciiOutsideOfQuotes) {
    for (const char* text : {"title = 1\u00e9\n", "\u00e9 = 1\n", "title = [1\u00a9]\n"})
        EXPECT_TRUE(tells(errorsOf(text + kBall), "a.toml:1:", "put it in quotes")) << text;
    // A column is a character, not a byte.
    EXPECT_TRUE(tells(errorsOf("title = '\u00e9\u00e9' \u00e9\n" + kBall),
                      "a.toml:1:14: ", "beyond ASCII"));
}

TEST(Reader, AllowsDotsInTexts) {
    EXPECT_EQ(read("title = '" + std::string(99, '.') + "'\n" + kBall).title.size(), 99u);
}

TEST(Reader, PrintsNoControlBytes) {
    const std::vector<std::string> lines =
        errorsOf("format = 1\n[[body]]\nname = \"\\u001b[31m\"\nshape = { sphere = 1 }\n");
    ASSERT_FALSE(lines.empty());
    EXPECT_EQ(listed(lines).find('\x1b'), std::string::npos);
    EXPECT_NE(listed(lines).find("\\x1b[31m"), std::string::npos);
    EXPECT_EQ(shown(std::string(64, 'a')), std::string(64, 'a'));
    EXPECT_EQ(shown(std::string(63, 'a') + "\xc3\xa9"), std::string(63, 'a') + "...");
    EXPECT_EQ(printable("a\n\x7f\xc2\x9b\xff\xc3\xa9"), "a\\x0a\\x7f\\xc2\\x9b\\xff\xc3\xa9");
    // A slash in two and three bytes, a single surrogate, beyond the last character, U+FFFF.
    EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");
    EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
    EXPECT_EQ(printable("\xef\xbf\xbf"), "\\xef\\xbf\\xbf");
    const std::string outermost =
        "\xe0\xa0\x80\xed\x9f\xbf\xef\xbf\xbd\xf0\x90\x80\x80\xf4\x8f\xbf\xbf";
    EXPECT_EQ(printable(outermost), outermost);
}

}  // namespace
}  // namespace demos::test
