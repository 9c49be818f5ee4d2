// Charts on paper: letters keep their size, so texts take more lines and names go below the plot.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "demos/charts/curve.h"
#include "demos/charts/drawing.h"
#include "demos/charts/layout.h"
#include "demos/look/inks.h"
#include "demos/text/stop.h"
#include "tests/demos/charts/column.h"
#include "tests/demos/charts/labels.h"

namespace demos {
namespace {

Chart chartOf(int lines, const std::string& name) {
    Chart chart;
    chart.title = "a chart of a title that does not go into one line of a column";
    chart.xTitle = "time", chart.xUnit = "s";
    chart.yTitle = "penetration: the deepest contact of the world", chart.yUnit = "mm";
    for (int i = 0; i < lines; ++i)
        chart.series.push_back(
            {name + " " + std::to_string(i), {0, 1, 2}, {0, 0.5, 1.0 + 0.01 * i}});
    return chart;
}

Drawing drawn(const std::vector<Chart>& charts, const Paper& paper) {
    return drawingOf(charts, chartSize(charts, paper, std::nullopt), "print", paper);
}

TEST(PaperChart, TextsNeitherOverlapNorLeaveThePage) {
    for (const double width : {40.0, 60.0, 85.0, 170.0})
        for (const int lines : {1, 3, 5, 12})
            for (const char* name : {"a", "floor and tower"}) {
                Chart names = chartOf(1, "");
                names.xTitle = "solver.type", names.xUnit = "";
                names.xNames = {"impulses", "pgs", "pgs-matrix"};
                expectApart(drawn({chartOf(lines, name), names}, {width, 150}),
                            ", " + std::to_string(width) + " mm, " + std::to_string(lines));
            }
}

TEST(PaperChart, NoTextLosesAnything) {
    for (const double width : {40.0, 85.0}) {
        const Drawing drawing = drawn({chartOf(12, "floor and tower")}, {width, 150});
        for (const Label& label : drawing.labels)
            EXPECT_EQ(label.text.find("…"), std::string::npos) << label.text;
        for (int i = 0; i < 12; ++i)
            EXPECT_TRUE(says(drawing, "floor and tower " + std::to_string(i))) << i;
        EXPECT_TRUE(says(drawing, "time (s)"));
    }
}

/// The legend's rows make the page higher and do not reduce the plot.
TEST(PaperChart, IsHigherForItsLegendAndItsPlotIsNot) {
    const auto plotOf = [](const Chart& chart) {
        return pageOf({chart}, chartSize(std::vector{chart}, kColumn, std::nullopt), kColumn)
            .plots.front();
    };
    Chart few = chartOf(2, "a"), many = chartOf(12, "floor and tower");
    few.title = many.title = "t";
    few.yTitle = many.yTitle = "y";
    EXPECT_GT(chartSize(std::vector{many}, kColumn, std::nullopt).height,
              chartSize(std::vector{few}, kColumn, std::nullopt).height + 3 * 39);
    EXPECT_TRUE(plotOf(few).legend.empty());
    EXPECT_NEAR(plotOf(many).bottom - plotOf(many).top, plotOf(few).bottom - plotOf(few).top, 2.0f);
}

/// The axis's title is below it, so a plot takes most of a column.
TEST(PaperChart, LeavesLittleBesideItsPlot) {
    Chart chart = chartOf(1, "");
    chart.series.front().label.clear();
    const Plot plot =
        pageOf({chart}, chartSize(std::vector{chart}, kColumn, std::nullopt), kColumn).plots[0];
    EXPECT_GT(plot.right - plot.left, 0.8f * 1004);
}

TEST(PaperChart, NeedsRoomForLetters) {
    EXPECT_THROW(chartSize(1, {39.0, 300}, std::nullopt), Stop);
    EXPECT_NO_THROW(chartSize(1, {40.0, 300}, std::nullopt));
    EXPECT_THROW(chartSize(4, kColumn, PictureSize{1000, 10}), Stop);
    EXPECT_THROW(chartSize(2, kColumn, PictureSize{85, 59}), Stop);
    EXPECT_NO_THROW(chartSize(2, kColumn, PictureSize{85, 61}));
    EXPECT_THROW(figureSize(kColumn, {1000, 10}), Stop);
}

TEST(PaperChart, LettersOfAnSvgAreOfWholePointsAtAnyResolution) {
    for (const int dpi : {72, 150, 300, 600}) {
        const Paper paper{85.0, dpi};
        const Chart chart = chartOf(1, "a");
        const std::string svg =
            svgOf({chart}, chartSize(std::vector{chart}, paper, std::nullopt), "print", paper);
        std::set<std::string> sizes;
        for (std::size_t at = 0; (at = svg.find("font-size=\"", at)) != svg.npos; ++at)
            sizes.insert(svg.substr(at + 11, svg.find('"', at + 11) - at - 11));
        ASSERT_EQ(sizes.size(), 2u) << dpi;
        std::set<double> points;
        for (const std::string& size : sizes) points.insert(std::stod(size) * 72.0 / dpi);
        EXPECT_NEAR(*points.begin(), 8.0, 0.01) << dpi;
        EXPECT_NEAR(*points.rbegin(), 9.0, 0.01) << dpi;
    }
}

TEST(Names, AreCutInTheMiddle) {
    const std::string a = fittedName("floor–tower0 (1)", 20.0f, 100.0f);
    const std::string b = fittedName("floor–tower0 (2)", 20.0f, 100.0f);
    EXPECT_LE(render::textWidth(a, 20.0f), 100.0f);
    EXPECT_NE(a, b);
    EXPECT_TRUE(a.starts_with("fl") && a.ends_with("1)")) << a;
    EXPECT_EQ(fittedName("short", 20.0f, 100.0f), "short");
    EXPECT_EQ(fittedName("–––", 20.0f, 1.0f), "");
}

TEST(NamedAxis, HasNamesAtItsTicksAndNoLineBetweenThem) {
    Chart chart;
    chart.xNames = {"impulses", "pgs"};
    chart.series = {{"", {0, 1}, {1, 2}}};
    for (const Paper& paper : {Paper{}, kColumn}) {
        const Drawing drawing = drawingOf({chart}, {1280, 720}, "print", paper);
        for (const std::string& name : chart.xNames) EXPECT_TRUE(says(drawing, name)) << name;
        EXPECT_EQ(drawing.lines.size(), 2u);
        for (const Line& line : drawing.lines) EXPECT_EQ(line.points.size(), 1u);
    }
}

TEST(LogAxis, HasItsTicksAtTheValues) {
    Chart chart;
    chart.logX = true;
    chart.series = {{"", {1, 2, 4, 8, 16, 32}, {1, 2, 3, 4, 5, 6}}};
    const Plot plot = pageOf({chart}, {1280, 720}).plots[0];
    EXPECT_EQ(plot.x.texts, (std::vector<std::string>{"1", "2", "4", "8", "16", "32"}));
    EXPECT_NEAR(plot.xOf(2) - plot.xOf(1), plot.xOf(32) - plot.xOf(16), 0.01f);
    EXPECT_FLOAT_EQ(plot.xOf(1), plot.left);
    for (const int width : {120, 200, 400})
        EXPECT_EQ(pageOf({chart}, {width, 720}).plots[0].x.ticks.size(), 6u) << width;
    EXPECT_EQ(pageOf({chart}, {64, 720}).plots[0].x.texts.back(), "");  // crowded
}

TEST(TimeAxis, BeginsAtZeroWhereTheFirstStepIsItsFirstValue) {
    Chart chart;
    chart.series = {{"", {1.0 / 60, 1.0, 2.0}, {1, 2, 3}}};
    EXPECT_EQ(pageOf({chart}, {1280, 720}).plots[0].x.low, 0.0);
    chart.series.front().x = {1.1, 1.5, 2.5};
    EXPECT_EQ(pageOf({chart}, {1280, 720}).plots[0].x.low, 1.1);
}

TEST(Units, OfSmallLengthsAreSmall) {
    const auto unitOf = [](double most) {
        Chart chart;
        chart.yUnit = "mm";
        chart.series = {{"", {0, 1}, {0, most}}};
        useFittingUnit(chart);
        return std::pair(chart.yUnit, chart.series.front().y.back());
    };
    EXPECT_EQ(unitOf(0.5), std::pair(std::string("mm"), 0.5));
    EXPECT_EQ(unitOf(0.0).first, "mm");
    EXPECT_EQ(unitOf(6e-4).first, "µm");
    EXPECT_NEAR(unitOf(6e-4).second, 0.6, 1e-12);
    EXPECT_EQ(unitOf(2e-7).first, "nm");
    EXPECT_EQ(unitOf(1.5e-10).first, "pm");
    EXPECT_NEAR(unitOf(1.5e-10).second, 0.15, 1e-12);
}

TEST(LogChart, LeavesOutWhatIsBelowItsLeast) {
    Chart chart;
    chart.logY = true;
    chart.yTitle = "residual";
    chart.series = {{"", {0, 1, 2}, {1e-16, 1e-2, 1e-3}}};
    chart.leastY = 1e-11;
    const Drawing drawing = drawingOf({chart}, {1280, 720}, "print");
    EXPECT_TRUE(says(drawing, "residual · 1 value of nearly 0 not shown"));
    EXPECT_EQ(pageOf({chart}, {1280, 720}).plots[0].y.low, 1e-3);
}

/// All four lines end at one point: each label has a leader.
TEST(EndLabels, AllHaveLeaders) {
    Chart chart;
    for (const char* label : {"(a)", "(b)", "(c)", "(d)"})
        chart.series.push_back({label, {0, 1}, {10, 0}});
    const Drawing drawing =
        drawingOf({chart}, chartSize(1, kColumn, std::nullopt), "print", kColumn);
    const Plot plot = pageOf({chart}, chartSize(1, kColumn, std::nullopt), kColumn).plots[0];
    const auto leaders =
        std::count_if(drawing.lines.begin(), drawing.lines.end(), [&](const Line& line) {
            return line.points.size() == 2 && line.points.front().x > plot.right;
        });
    EXPECT_EQ(leaders, 4);
}

TEST(Inks, OfALineAreThoseItNames) {
    Chart chart;
    chart.series = {{"total", {0, 1}, {1, 2}}};
    chart.series.front().ink = 4;
    const render::Color seen = drawingOf({chart}, {1280, 720}, "print").lines.front().color;
    const render::Color meant = lineColor(4, inksOf("print"));
    EXPECT_EQ(seen.r, meant.r);
    EXPECT_EQ(seen.b, meant.b);
}

}  // namespace
}  // namespace demos
