#include "demos/comparisons/measure_table.h"

#include <gtest/gtest.h>

#include "demos/charts/fitting_unit.h"

namespace demos {
namespace {

Measured withValues(const std::string& label, double drift, double energy) {
    Measured run;
    run.variant.label = label;
    run.summary.values.assign(measures().size(), 0.0);
    run.summary.values[static_cast<std::size_t>(measureCalled("drift"))] = drift;
    run.summary.values[static_cast<std::size_t>(measureCalled("energy"))] = energy;
    return run;
}

TEST(FittingUnit, NeedsNoPowersOfTen) {
    struct Case {
        const char* unit;
        double largest, scale;
        const char* name;
    };
    for (const Case& c : {Case{"mm", 3.5e7, 1e-6, "km"}, Case{"mm", 9999, 1, "mm"},
                          Case{"mm", 2e-5, 1e3, "µm"}, Case{"J", 4.5e5, 1e-3, "kJ"},
                          Case{"J", 0.0005, 1e3, "mJ"}, Case{"m/s", 2e4, 1e-3, "km/s"},
                          Case{"N s", 12, 1, "N s"}, Case{"ms", 1e9, 1, "ms"}, Case{"", 1e9, 1, ""},
                          Case{"mm", 0, 1, "mm"}}) {
        const FittingUnit unit = fittingUnit(c.unit, c.largest);
        EXPECT_EQ(unit.name, c.name) << c.unit << ' ' << c.largest;
        EXPECT_NEAR(unit.scale, c.scale, 1e-9 * c.scale) << c.unit << ' ' << c.largest;
    }
}

TEST(MeasureTable, HasOneUnitAColumnThatFitsItsLargestValue) {
    const MeasureCells cells = cellsOf({withValues("a", 35.81e3, -4.458e5), withValues("b", 12.0, 100.0)});
    EXPECT_EQ(cells.head, (std::vector<std::string>{"drift (km)", "energy change (kJ)"}));
    EXPECT_EQ(cells.rows[0], (std::vector<std::string>{"35.81", "-445.8"}));
    EXPECT_EQ(cells.rows[1], (std::vector<std::string>{"0.012", "0.1"}));
}

TEST(MeasureTable, IsAlignedUnderLongNames) {
    const std::string text = tableText({withValues("a", 35.81e3, -4.458e5)});
    EXPECT_EQ(text.find('\n'), text.size() - text.find('\n') - 1) << text;
}

TEST(HistoryChart, SaysWhatIsMeasuredAtATime) {
    Measured run = withValues("a", 1.0, 2.0);
    run.summary.time = {0.0};
    run.summary.history.assign(measures().size(), {0.0});
    const auto title = [&](const char* name) {
        return historyChart({run}, measureCalled(name), "").yTitle;
    };
    EXPECT_EQ(title("energy"), "energy: change since the start");
    EXPECT_EQ(title("penetration"), "penetration: deepest contact");
    EXPECT_EQ(title("drift"), "drift: largest horizontal way of a body");
}

TEST(MeasureTable, WritesSmallNumbersWithoutPowersOfTen) {
    const MeasureCells cells = cellsOf({withValues("a", 0.005, 1.0), withValues("b", 3e-8, 2e-5)});
    EXPECT_EQ(cells.head, (std::vector<std::string>{"drift (mm)", "energy change (J)"}));
    EXPECT_EQ(cells.rows[1], (std::vector<std::string>{"0.000030", "0.000020"}));
}

TEST(MeasureTable, LeavesOutWhatIsOnlyRounding) {
    const MeasureCells cells = cellsOf({withValues("a", 4e-13, -3.6e-9), withValues("b", 0.0, 0.0)});
    EXPECT_TRUE(cells.head.empty());
    const MeasureCells one = cellsOf({withValues("a", 0.49999999998, 2.0), withValues("b", 3e-12, 0.0)});
    EXPECT_EQ(one.rows[0], (std::vector<std::string>{"500", "2"}));
    EXPECT_EQ(one.rows[1], (std::vector<std::string>{"0", "0"}));
}

TEST(MeasureTable, MarksRunsWhoseExpectationsFailed) {
    std::vector<Measured> runs = {withValues("a", 1.0, 2.0), withValues("b", 1.0, 2.0),
                                  withValues("c", 1.0, 2.0)};
    EXPECT_EQ(failedRunsLine(runs), "");
    runs[1].summary.failed = runs[2].summary.failed = "the expectation failed: x: 2 m";
    EXPECT_EQ(failedRunsLine(runs), "b: the expectation failed: x: 2 m; also 1 other run");
    const std::string text = tableText(runs);
    EXPECT_EQ(text.find("\nb") < text.find("  expectation failed\nc"), true) << text;
    EXPECT_TRUE(text.ends_with("  expectation failed")) << text;
    EXPECT_NE(jsonLine(runs[0]).find("\"failed\":null"), std::string::npos);
    EXPECT_NE(jsonLine(runs[1]).find("\"failed\":\"the"), std::string::npos);
}

}  // namespace
}  // namespace demos
