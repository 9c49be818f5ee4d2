// Malformed and extreme input: each gives exactly one line, which states what would be right.

#include <gtest/gtest.h>

#include "tests/demos/reading.h"
#include "tests/support/text.h"

namespace demos::test {
namespace {

struct BadInput {
    const char* what;
    std::string text;  // the whole file
    const char* place;
    std::string message;
};

std::ostream& operator<<(std::ostream& out, const BadInput& bad) { return out << bad.what; }

class BadInputs : public testing::TestWithParam<BadInput> {};

TEST_P(BadInputs, AreOneLine) {
    const BadInput& bad = GetParam();
    const std::vector<std::string> lines = errorsOf(bad.text);
    ASSERT_EQ(lines.size(), 1u) << listed(lines);
    EXPECT_TRUE(tells(lines, std::string("a.toml:") + bad.place + ": ", bad.message))
        << listed(lines);
}

const std::string kFormat = "format = 1\n";
const std::string kOneBall = kFormat + kBall;  // the next line is 6

/// Three joints, or two forces, in 10000 turns.
std::string tenThousand(const std::string& what) {
    return kOneBall + "[[repeat]]\ncount = 10000\n" + what + "\n";
}

const std::string kWeld = "{ type = 'weld', a = 'ball', b = 'world', anchor = [0, 0, 0] }";
const std::string kPush = "{ type = 'constant', force = [1, 0, 0] }";

TEST(BadOption, IsCutWhereItIsLong) {
    const std::string option = "world.hz=" + std::string(100'000, '9');
    const std::vector<std::string> lines = errorsOf(kOneBall, {option});
    ASSERT_EQ(lines.size(), 1u) << listed(lines);
    EXPECT_LT(lines.front().size(), 400u);
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadInputs,
    testing::Values(
        BadInput{"empty", "", "1:1", "begin it with format = 1"},
        BadInput{"NUL", std::string("format = 1\n\0", 12), "2:1", "not TOML"},
        BadInput{"UTF-16", std::string("\xff\xfe[\0", 4), "1:1", "UTF-16; save the file as UTF-8"},
        BadInput{"UTF-16, the other way", std::string("\xfe\xff\0[", 4), "1:1",
                 "UTF-16; save the file as UTF-8"},
        BadInput{"cut in a text", kFormat + "title = \"a", "2:11", "not TOML"},
        BadInput{"beyond every number", "seconds = 1e999\n" + kOneBall, "1:16", "not TOML"},
        BadInput{"beyond 64 bits", "seconds = 9999999999999999999\n" + kOneBall, "1:30",
                 "not TOML"},
        BadInput{"an expression beyond what is exact", kOneBall + "[world]\nseed = '9007199254740993 - 1'\n",
                 "7:8", "9007199254740993 is not exact"},
        BadInput{"beyond what is exact", kOneBall + "[world]\nseed = 9007199254740993\n", "7:8",
                 "9007199254740993 is not exact"},
        BadInput{"an inertia that no body has", kOneBall + "mass = 1\ninertia = [1, 1, 2.1]\n",
                 "7:1", "no principal moment larger than the sum of the others"},
        BadInput{"an inertia that no body has, turned",
                 kOneBall + "mass = 1\ninertia = [1, 1, 1, 0.7, 0, 0]\n", "7:1",
                 "no principal moment larger"},
        BadInput{"an expression without end",
                 kOneBall + "mass = '" + std::string(5000, '(') + "'\n", "6:8",
                 "5000 characters; it should be at most 200"}));

/// `count` parts, each of which is `part`.
std::string compoundOf(int count, const std::string& part) {
    std::string list;
    for (int i = 0; i < count; ++i) list += "{ shape = " + part + " },";
    return "{ compound = [" + list + "] }";
}

std::string bodyOf(const std::string& shape) {
    return kFormat + "[[body]]\nname = 'a'\nshape = " + shape + "\n";
}

std::string expectations(int count, const std::string& keys) {
    std::string text = kOneBall;
    for (int i = 0; i < count; ++i) text += "[[expect]]\n" + keys;
    return text;
}

INSTANTIATE_TEST_SUITE_P(
    Limits, BadInputs,
    testing::Values(BadInput{"parts of parts",
                             bodyOf(compoundOf(40, compoundOf(30, "{ sphere = 1 }"))), "4:11",
                             "compound has 1200 parts; it should have 1 to 1000"},
                    BadInput{"values of all bodies",
                             kFormat + "[[repeat]]\ncount = 4000\nbody = { name = 'a{i}', shape = " +
                                 compoundOf(200, "{ sphere = 1 }") + " }\n",
                             "4:8", "more than 2000000 values in all bodies, joints and forces"},
                    BadInput{"expectations",
                             expectations(1001, "what = 'speed'\nbelow = 1\n"), "6:3",
                             "1001 [[expect]]s; a scene should have at most 1000"},
                    BadInput{"names of an expectation",
                             expectations(1, "what = 'speed'\nbelow = 1\nof = [" +
                                                 support::repeated("'ball',", 101) + "]\n"),
                             "9:1", "101 names; they should be at most 100"},
                    BadInput{"a long name of an expectation",
                             expectations(1, "what = 'speed'\nbelow = 1\nof = '" +
                                                 std::string(1000, '*') + "'\n"),
                             "9:1", "no body is called '" + std::string(64, '*') + "...'"},
                    BadInput{"what expectations watch",
                             "seconds = 1e5\n" + kFormat + "[[repeat]]\ncount = 100\nbody = { name = "
                             "'a{i}', shape = { sphere = 1 } }\n[[expect]]\nwhat = 'period'\n"
                             "below = 1\n",
                             "6:1", "600000000 steps of periods"},
                    BadInput{"pictures of a snapshot",
                             kOneBall + "[snapshot]\nsize = [9000, 9000]\ntimes = [0, 1]\n", "8:1",
                             "2 pictures of 9000x9000; they should have at most 134217728 pixels"},
                    BadInput{"joints",
                             tenThousand("joint = [" + kWeld + ", " + kWeld + ", " + kWeld + "]"),
                             "8:138", "more than 20000 joints; make the scene or a count smaller"},
                    BadInput{"forces", tenThousand("force = [" + kPush + ", " + kPush + "]"),
                             "8:10", "more than 10000 forces; make the scene or a count smaller"},
                    BadInput{"long name",
                             kFormat + "[[body]]\nname = '" + std::string(65, 'a') +
                                 "'\nshape = { sphere = 1 }\n",
                             "3:1", "it should be 1 to 64 of A-Z"},
                    BadInput{"empty name",
                             kFormat + "[[body]]\nname = ''\nshape = { sphere = 1 }\n", "3:1",
                             "name is ''; it should be 1 to 64 of A-Z"},
                    BadInput{"no mass", kOneBall + "mass = -1\n", "6:8",
                             "mass is -1; it should be a number from 1e-06 to 1e+09 kg"},
                    BadInput{"size", kFormat + "[[body]]\nname = 'a'\nshape = { sphere = 1001 }\n",
                             "4:20", "sphere is 1001; it should be a number from 0.001 to 1000 m"},
                    BadInput{"step", kOneBall + "[world]\nhz = 100001\n", "7:6",
                             "it should be a whole number from 10 to 100000 steps a second"},
                    BadInput{"picture", kOneBall + "[snapshot]\nsize = [0, 360]\n", "7:9",
                             "it should be a number from 1 to 16384 pixels"},
                    BadInput{"quaternion of three", kOneBall + "quaternion = [1, 0, 0]\n", "6:1",
                             "quaternion should be four numbers"}));

}  // namespace
}  // namespace demos::test
