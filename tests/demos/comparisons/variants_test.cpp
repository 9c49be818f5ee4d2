// One scene under several settings: how they are written, read and laid out.
#include "demos/film/variants.h"
#include "demos/load/load_scene.h"

#include <gtest/gtest.h>

#include "demos/comparisons/comparisons.h"
#include "demos/comparisons/measure_table.h"
#include "demos/film/panel_layout.h"
#include "demos/load/builtin.h"
#include "demos/scene/reader.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

using Texts = std::vector<std::string>;

std::string usageError(const std::string& text, bool range) {
    try {
        range ? rangeFrom(text, "--over") : variationFrom(text, "--vary");
    } catch (const Stop& stop) {
        EXPECT_EQ(stop.code(), Exit::usage);
        return stop.what();
    }
    return {};
}

TEST(Variation, PartsAtCommasOutsideBrackets) {
    EXPECT_EQ(variationFrom("a.b=1,2", "--vary").values, (Texts{"1", "2"}));
    EXPECT_EQ(variationFrom("world.gravity=[0,-1,0],[0,-9.81,0]", "--vary").values,
              (Texts{"[0,-1,0]", "[0,-9.81,0]"}));
    EXPECT_EQ(variationFrom("title='a, b',c", "--vary").values, (Texts{"'a, b'", "c"}));
    EXPECT_EQ(variationFrom("a.b=1", "--vary").key, "a.b");
}

TEST(Variation, SaysWhatItShouldLookLike) {
    for (const char* bad : {"solver.sweeps", "=3", "solver.sweeps="})
        EXPECT_NE(usageError(bad, false).find("KEY=VALUE"), std::string::npos) << bad;
}

TEST(Range, CountsDoublesAndSteps) {
    EXPECT_EQ(rangeFrom("k=1..4", "--over").values, (Texts{"1", "2", "3", "4"}));
    EXPECT_EQ(rangeFrom("k=1..64:x2", "--over").values,
              (Texts{"1", "2", "4", "8", "16", "32", "64"}));
    EXPECT_EQ(rangeFrom("k=0..1:0.25", "--over").values, (Texts{"0", "0.25", "0.5", "0.75", "1"}));
    EXPECT_EQ(rangeFrom("k=0..0.3:0.1", "--over").values.back(), "0.3");  // no error adds up
    EXPECT_EQ(rangeFrom("k=pgs,impulses", "--over").values.size(), 2u);
    EXPECT_EQ(rangeFrom("k=-2..2", "--over").values.front(), "-2");
}

TEST(Range, RefusesWhatHasNoEnd) {
    EXPECT_NE(usageError("k=0..1:0", true).find("above 0"), std::string::npos);
    EXPECT_NE(usageError("k=1..8:x1", true).find("above 1"), std::string::npos);
    EXPECT_NE(usageError("k=0..8:x2", true).find("above 0"), std::string::npos);
    EXPECT_NE(usageError("k=4..1", true).find("upwards"), std::string::npos);
    EXPECT_NE(usageError("k=0.1..0.9", true).find("needs a step"), std::string::npos);
    EXPECT_NE(usageError("k=1..1000000", true).find("more than 1000"), std::string::npos);
    EXPECT_NE(usageError("k=1..nan", true).find("a list"), std::string::npos);
    EXPECT_NE(usageError("k=3", true).find("a range"), std::string::npos);
}

TEST(Combinations, ChangeTheLastFastest) {
    const auto all = combinations({{"a", {"1", "2"}}, {"b", {"3", "4"}}});
    EXPECT_EQ(all,
              (std::vector<Texts>{{"a=1", "b=3"}, {"a=1", "b=4"}, {"a=2", "b=3"}, {"a=2", "b=4"}}));
}

TEST(Variants, AreReadAndLabelledByWhatDiffers) {
    Options options;
    options.scenes = {"pendulum"};
    const auto variants = variantsOf(
        options,
        {{"solver.preset=seed", "solver.sweeps=1"}, {"solver.preset=seed", "solver.sweeps=4"}}, {},
        "--vary");
    ASSERT_EQ(variants.size(), 2u);
    EXPECT_EQ(variants[1].label, "sweeps=4");
    EXPECT_EQ(variants[1].scene.settings.sweeps, 4);
}

TEST(Variants, AreWrongUnderTheirOwnOption) {
    Options options;
    options.scenes = {"pendulum"};
    try {
        variantsOf(options, {{"solver.sweeps=1.5"}}, {}, "--over");
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_EQ(error.lines().at(0),
                  "--over solver.sweeps=1.5: sweeps is 1.5; it should be a whole number from 0 to "
                  "10000");
    }
}

TEST(Comparisons, AreReadyToBePlayed) {
    for (const Comparison& comparison : builtinComparisons()) {
        EXPECT_GE(comparison.cases.size(), 2u);
        EXPECT_LE(comparison.cases.size(), 4u);
        EXPECT_GE(measureCalled(comparison.plot), 0) << comparison.name;
        for (const BuiltinScene& scene : builtinScenes()) EXPECT_NE(scene.name, comparison.name);
        for (const Comparison::Case& one : comparison.cases)
            EXPECT_NO_THROW(loadScene(comparison.scene, one.settings)) << comparison.name;
    }
}

/// What the comparisons should show.
Summary played(const char* comparison, std::size_t number) {
    const Comparison& c = *comparisonCalled(comparison);
    SceneDescription scene = loadScene(c.scene, c.cases.at(number).settings);
    scene.seconds = c.seconds;
    return summarize(scene);
}
double valueOf(const Summary& summary, const char* measure) {
    return summary.values.at(static_cast<std::size_t>(measureCalled(measure)));
}

TEST(Comparisons, ClampingTheCorrectionLetsTheStackSink) {
    EXPECT_LT(valueOf(played("clamping", 0), "penetration"), 0.01);
    EXPECT_GT(valueOf(played("clamping", 1), "penetration"), 0.05);
}

TEST(Comparisons, ThePresetsOfFilmsHoldATonneOnAKilogram) {
    EXPECT_GT(valueOf(played("presets", 0), "penetration"), 0.01);
    for (const std::size_t other : {1u, 2u})
        EXPECT_LT(valueOf(played("presets", other), "penetration"), 0.002);
}

TEST(Comparisons, BaumgarteThrowsTheBallUpAndNudgesDoNot) {
    EXPECT_LT(valueOf(played("nudges", 0), "speed"), 0.1);
    EXPECT_GT(valueOf(played("nudges", 1), "speed"), 1.0);
}

TEST(Comparisons, PgsIsImpulses) {
    const Summary impulses = played("pgs", 0);
    for (const std::size_t other : {1u, 2u})
        EXPECT_NEAR(valueOf(played("pgs", other), "separation"), valueOf(impulses, "separation"),
                    1e-6);
}

TEST(Comparisons, SubstepsBeatSweeps) {
    EXPECT_LT(valueOf(played("substeps", 2), "separation"),
              0.25 * valueOf(played("substeps", 0), "separation"));
}

TEST(PanelLayout, FillsThePictureWithEqualPanels) {
    for (int panels = 1; panels <= 16; ++panels)
        for (const bool strip : {false, true}) {
            const int odd = panels % 2;
            const PanelLayout layout = panelLayout(panels, strip, 1280 + odd, 720 + odd);
            ASSERT_EQ(layout.panels.size(), static_cast<std::size_t>(panels));
            EXPECT_EQ(layout.width, 1280 + odd);
            EXPECT_EQ(layout.height, 720 + odd);
            EXPECT_EQ(layout.strip.width > 0, strip);
            std::vector<Area> all = layout.panels;
            if (strip) all.push_back(layout.strip);
            for (std::size_t i = 0; i < all.size(); ++i) {
                EXPECT_LE(all[i].x + all[i].width, layout.width);
                EXPECT_LE(all[i].y + all[i].height, layout.height);
                for (std::size_t k = 0; k < i; ++k) {
                    const bool apart = all[i].x >= all[k].x + all[k].width ||
                                       all[k].x >= all[i].x + all[i].width ||
                                       all[i].y >= all[k].y + all[k].height ||
                                       all[k].y >= all[i].y + all[i].height;
                    EXPECT_TRUE(apart) << panels << ": " << i << " and " << k;
                }
            }
        }
}

TEST(PanelLayout, ASinglePictureKeepsItsSize) {
    const PanelLayout layout = panelLayout(1, false, 641, 359);
    EXPECT_EQ(layout.panels[0].width, 641);
    EXPECT_EQ(layout.height, 359);
}

}  // namespace
}  // namespace demos
