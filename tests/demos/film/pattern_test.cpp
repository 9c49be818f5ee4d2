#include "demos/film/pattern.h"

#include <gtest/gtest.h>

#include "demos/text/stop.h"

namespace demos {
namespace {

const PatternValues kValues{42, 1.4, "stack", "high"};

TEST(Pattern, HashesAreTheFrameFilledUpWithZeros) {
    EXPECT_EQ(expandPattern("a_####.png", kValues), "a_0042.png");
    EXPECT_EQ(expandPattern("#.png", kValues), "42.png");
}

TEST(Pattern, BracesNameWhatTheyStandFor) {
    EXPECT_EQ(expandPattern("{scene}/{quality}/{frame:6}.png", kValues), "stack/high/000042.png");
    EXPECT_EQ(expandPattern("{frame}_{time}.png", kValues), "42_1.400.png");
}

TEST(Pattern, PrintfsHolesAreTheFrame) {
    EXPECT_EQ(expandPattern("f_%06d.png", kValues), "f_000042.png");
    EXPECT_EQ(expandPattern("%d.png", kValues), "42.png");
    EXPECT_EQ(expandPattern("%%06d_%01d.png", kValues), "%06d_42.png");
    EXPECT_EQ(expandPattern("50%_%s_%6d_5%", kValues), "50%_%s_%6d_5%");
    EXPECT_TRUE(namesEveryFrame("f_%04d.png"));
    EXPECT_FALSE(namesEveryFrame("f_%%04d.png"));
    EXPECT_THROW(expandPattern("%013d", kValues), Stop);
    EXPECT_THROW(expandPattern("%0999999999999999999999d", kValues), Stop);
}

TEST(Pattern, DoubledBracesAreBraces) { EXPECT_EQ(expandPattern("{{{frame}}}", kValues), "{42}"); }

TEST(Pattern, WhatIsNotUnderstoodIsAnError) {
    for (const char* bad : {"{farme}", "{frame", "frame}", "{frame:}", "{frame:x}", "{frame:99}",
                            "{frame:0}", "{scene:3}", "{}", "#############"})
        EXPECT_THROW(expandPattern(bad, kValues), Stop) << bad;
}

TEST(Pattern, ErrorsNameTheNearest) {
    try {
        expandPattern("{farme}", kValues);
    } catch (const Stop& stop) {
        EXPECT_NE(std::string(stop.what()).find("did you mean 'frame'"), std::string::npos);
        EXPECT_EQ(stop.code(), Exit::usage);
    }
}

TEST(Pattern, KnowsWhetherFramesGetNamesOfTheirOwn) {
    EXPECT_TRUE(namesEveryFrame("a_##.png"));
    EXPECT_TRUE(namesEveryFrame("{frame}.png"));
    EXPECT_TRUE(namesEveryFrame("{time}.png"));
    EXPECT_FALSE(namesEveryFrame("{scene}.png"));
    EXPECT_FALSE(namesEveryFrame("{{frame}}.png"));
}

}  // namespace
}  // namespace demos
