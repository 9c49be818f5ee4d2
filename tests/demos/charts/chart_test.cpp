#include "demos/charts/chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

#include "demos/charts/curve.h"
#include "demos/charts/drawing.h"
#include "demos/charts/layout.h"
#include "demos/charts/ticks.h"
#include "demos/look/inks.h"
#include "tests/demos/charts/labels.h"
#include "tests/support/text.h"

namespace demos {
namespace {

using render::Point;
using support::count;
using Texts = std::vector<std::string>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr PictureSize kPage{1280, 720};

Texts linearTexts(double low, double high, double most) {
    return linearAxis(low, high, most, Reach::ticks, false).texts;
}

TEST(Ticks, AreOneTwoOrFiveTimesAPowerOfTen) {
    for (double range = 1e-9; range < 1e9; range *= 1.7)
        for (const double most : {3.0, 5.0, 8.0}) {
            const Axis axis = linearAxis(0.0, range, most, Reach::data, false);
            const double step = axis.ticks.at(1) - axis.ticks.at(0);
            const double mantissa = step / std::pow(10.0, std::floor(std::log10(step * 1.000001)));
            EXPECT_TRUE(std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 ||
                        std::abs(mantissa - 5) < 1e-6)
                << step;
            EXPECT_LE(axis.ticks.size(), most + 1);
            EXPECT_GE(axis.ticks.front(), axis.low);
            EXPECT_LE(axis.ticks.back(), axis.high * (1 + 1e-9));
        }
}

TEST(Ticks, AreWrittenWithoutNoise) {
    EXPECT_EQ(linearTexts(0, 0.3, 3), (Texts{"0", "0.1", "0.2", "0.3"}));
    EXPECT_EQ(linearTexts(-1, 1, 2), (Texts{"−1", "0", "1"}));
    EXPECT_EQ(linearTexts(0, 4000, 4), (Texts{"0", "1000", "2000", "3000", "4000"}));
    EXPECT_EQ(linearTexts(0, 40000, 4), (Texts{"0", "10k", "20k", "30k", "40k"}));
    EXPECT_EQ(linearTexts(0, 1.5e6, 3), (Texts{"0", "0.5M", "1.0M", "1.5M"}));
    EXPECT_EQ(linearTexts(0, 4e-4, 2), (Texts{"0", "2×10⁻⁴", "4×10⁻⁴"}));
    EXPECT_EQ(tickText(2e20, 1e20, 3e20), "2×10²⁰");
}

TEST(Ticks, AreWholeWhereTheValuesAre) {
    EXPECT_EQ(linearAxis(1, 2, 8, Reach::data, true).texts, (Texts{"1", "2"}));
}

TEST(Ticks, TheTickAtTheEndSurvivesRounding) {
    double time = 0.0;
    for (int i = 0; i < 420; ++i) time += 1.0 / 60;  // 7 s, nearly
    EXPECT_EQ(linearAxis(0, time, 7, Reach::data, false).texts.back(), "7");
}

TEST(Ticks, AConstantStandsInAnAxisWithZero) {
    for (const double value : {0.0, 5.0, -5.0, 1e-200, 1e200, 66.1234567}) {
        const Axis axis = linearAxis(value, value * (1 + 1e-12), 5, Reach::ticks, false);
        EXPECT_LT(axis.low, axis.high);
        EXPECT_LE(axis.low, 0.0);
        EXPECT_GE(axis.high, 0.0);
        EXPECT_GE(axis.ticks.size(), 2u) << value;
    }
}

TEST(Ticks, DecadesHaveSuperscripts) {
    EXPECT_EQ(decadeText(-6), "10⁻⁶");
    EXPECT_EQ(decadeText(0), "1");
    EXPECT_EQ(decadeText(12), "10¹²");
    EXPECT_EQ(logAxis(2e-3, 3.0, 8).texts, (Texts{"10⁻³", "10⁻²", "10⁻¹", "1", "10"}));
    EXPECT_EQ(logAxis(1e-3, 1e-3, 8).texts, (Texts{"10⁻⁴", "10⁻³", "10⁻²"}));
    EXPECT_EQ(logAxis(1e-15, 1.0, 4).texts, (Texts{"10⁻¹⁵", "10⁻¹⁰", "10⁻⁵", "1"}));
}

TEST(Ticks, ALogAxisPlacesDecadesEvenly) {
    const Axis axis = logAxis(1e-4, 1.0, 8);
    EXPECT_NEAR(axis.share(1e-4), 0.0, 1e-12);
    EXPECT_NEAR(axis.share(1e-1), 0.75, 1e-12);
}

TEST(EndLabels, AreMovedApartAndKeepTheirOrder) {
    const std::vector<float> wanted = {50, 50, 10, 48, 90, 91};
    const std::vector<float> y = separated(wanted, 12.0f, 0.0f, 100.0f);
    for (std::size_t i = 0; i < y.size(); ++i)
        for (std::size_t k = 0; k < y.size(); ++k) {
            if (i == k) continue;
            EXPECT_GE(std::abs(y[i] - y[k]), 12.0f - 1e-3f);
            if (wanted[i] < wanted[k]) {
                EXPECT_LT(y[i], y[k]);
            }
        }
    EXPECT_LT(y[0], y[1]);  // equal positions: in the order given
    for (const float place : y) EXPECT_TRUE(place >= 0.0f && place <= 100.0f) << place;
}

TEST(EndLabels, StayWhereThereIsRoomAndShareTheShiftWhereThereIsNot) {
    EXPECT_EQ(separated({10, 50, 90}, 12, 0, 100), (std::vector<float>{10, 50, 90}));
    EXPECT_EQ(separated({50, 50}, 12, 0, 100), (std::vector<float>{44, 56}));
    EXPECT_EQ(separated({0, 0, 0}, 10, 0, 100), (std::vector<float>{0, 10, 20}));
    EXPECT_EQ(separated({100, 100}, 10, 0, 100), (std::vector<float>{90, 100}));
}

TEST(Thinning, KeepsEveryColumnsExtremes) {
    std::vector<Point> points;
    for (int i = 0; i < 100000; ++i)
        points.push_back({static_cast<float>(i) / 1000.0f, i == 54321   ? -7.0f
                                                           : i == 54322 ? 9.0f
                                                                        : 0.0f});
    const std::vector<Point> kept = thinned(points);
    EXPECT_LE(kept.size(), 200u);
    float low = 0, high = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        low = std::min(low, kept[i].y), high = std::max(high, kept[i].y);
        if (i > 0) {
            EXPECT_GE(kept[i].x, kept[i - 1].x);
        }
    }
    EXPECT_EQ(low, -7.0f);
    EXPECT_EQ(high, 9.0f);
}

TEST(Thinning, LeavesFewPointsAlone) {
    const std::vector<Point> points = {{0, 1}, {0.5f, 2}, {3, 3}, {9, 4}};
    EXPECT_EQ(thinned(points).size(), 4u);
    EXPECT_TRUE(thinned({}).empty());
}

/// A wave and its double, one second long.
Chart waves() {
    Chart chart;
    chart.title = "waves";
    chart.xTitle = "time", chart.xUnit = "s";
    chart.yTitle = "height", chart.yUnit = "mm";
    chart.series = {{"one", {}, {}}, {"two", {}, {}}};
    for (int i = 0; i <= 500; ++i)
        for (Series& series : chart.series) {
            series.x.push_back(i / 500.0);
            series.y.push_back((&series == &chart.series[0] ? 1 : 2) * std::sin(i / 40.0));
        }
    return chart;
}

Chart single(std::vector<double> x, std::vector<double> y) {
    Chart chart;
    chart.title = "t";
    chart.series = {{"a", std::move(x), std::move(y)}};
    return chart;
}

/// Every tag is closed in the right order, and no character is invalid in XML.
testing::AssertionResult isWellFormed(const std::string& xml) {
    std::vector<std::string> open;
    const std::regex tag(R"(<(/?)([a-z]+)((?: [a-zA-Z-]+="[^"<&]*(?:&[a-z]+;[^"<&]*)*")*)(/?)>)");
    std::string rest = xml;
    for (std::smatch found; std::regex_search(rest, found, tag); rest = found.suffix()) {
        if (found.prefix().str().find_first_of("<>") != std::string::npos)
            return testing::AssertionFailure() << "no tag: " << found.prefix().str();
        if (found[1].length() == 0) {
            if (found[4].length() == 0) open.push_back(found[2]);
        } else if (open.empty() || open.back() != found[2]) {
            return testing::AssertionFailure() << "closes nothing: " << found.str();
        } else {
            open.pop_back();
        }
    }
    if (!open.empty()) return testing::AssertionFailure() << "not closed: " << open.back();
    for (const char c : xml)
        if (static_cast<unsigned char>(c) < 32 && c != '\n')
            return testing::AssertionFailure() << "control byte";
    return testing::AssertionSuccess();
}

TEST(Drawing, NamesItsAxesWithUnitsAndItsLinesAtTheirEnds) {
    const Drawing drawing = drawingOf({waves()}, kPage, "studio");
    for (const char* text : {"waves", "time (s)", "height (mm)", "one", "two", "0", "0.5"})
        EXPECT_TRUE(says(drawing, text)) << text;
}

Chart manyEnds(int lines) {
    Chart chart = waves();
    for (int i = 2; i < lines; ++i) {
        chart.series.push_back(chart.series[0]);
        chart.series.back().label = "line number " + std::to_string(i);
    }
    return chart;
}

TEST(Drawing, TextsNeitherOverlapNorLeaveThePicture) {
    for (const PictureSize size : {PictureSize{1280, 720}, {1920, 1080}, {640, 480}, {480, 270}})
        for (const int lines : {2, 12, 40}) {
            const Drawing drawing = drawingOf({manyEnds(lines), waves()}, size, "dark");
            expectApart(drawing, ", " + std::to_string(size.width) + " wide, " +
                                     std::to_string(lines) + " lines");
        }
}

TEST(Drawing, WhatHasNoRoomIsCounted) {
    const Drawing drawing = drawingOf({manyEnds(40)}, {640, 240}, "studio");
    bool more = false;
    for (const Label& label : drawing.labels) more = more || label.text.starts_with("+ ");
    EXPECT_TRUE(more);
}

TEST(Drawing, LinesStayInTheirPlot) {
    const Page page = pageOf({waves()}, kPage);
    for (const Line& line : drawingOf({waves()}, kPage, "studio").lines)
        for (const Point& point : line.points) {
            EXPECT_GE(point.y, page.plots[0].top - 0.01f);
            EXPECT_LE(point.y, page.plots[0].bottom + 0.01f);
            EXPECT_GE(point.x, page.plots[0].left - 0.01f);
        }
}

TEST(Drawing, ChartsOfOneRunShareTheirTimeAxis) {
    Chart late = waves();
    late.series[0].y.front() = late.series[1].y.front() = kNan;
    const Page page = pageOf({waves(), late}, kPage);
    EXPECT_EQ(page.plots[0].xOf(0.5), page.plots[1].xOf(0.5));
}

TEST(Drawing, AGapIsNotBridged) {
    const Drawing whole = drawingOf({single({0, 1, 2, 3, 4}, {1, 2, 3, 4, 5})}, kPage, "studio");
    const Drawing cut = drawingOf({single({0, 1, 2, 3, 4}, {1, 2, kNan, 4, 5})}, kPage, "studio");
    const auto pieces = [](const Drawing& drawing) {
        int lines = 0;  // longer than a leader
        for (const Line& line : drawing.lines)
            lines += line.points.size() > 1 && line.points.front().x < 1000.0f;
        return lines;
    };
    EXPECT_EQ(pieces(whole), 1);
    EXPECT_EQ(pieces(cut), 2);
}

TEST(Drawing, ALogAxisSaysWhatItLeavesOut) {
    Chart chart = single({1, 2, 3, 4}, {0.1, 0.0, 0.001, 0.0});
    chart.logY = true;
    chart.yTitle = "residual", chart.yUnit = "m/s";
    EXPECT_TRUE(
        says(drawingOf({chart}, kPage, "studio"), "residual (m/s) · 2 values of 0 not shown"));
    chart.series[0].y = {0.1, -1.0, 0.001, kNan};
    EXPECT_TRUE(says(drawingOf({chart}, kPage, "studio"),
                     "residual (m/s) · 1 value of 0 or below not shown"));
}

TEST(Drawing, SaysNoDataWhereThereIsNone) {
    Chart log = single({0, 1}, {0, -1});
    log.logY = true;
    for (const Chart& chart :
         {Chart{}, single({}, {}), single({0, 1}, {kNan, kNan}), log, single({kNan}, {1}),
          single({0, 1}, {kInfinity, -kInfinity}), single({1, 2, 3}, {})}) {
        EXPECT_FALSE(hasData(chart));
        EXPECT_TRUE(says(drawingOf({chart}, kPage, "studio"), "no data"));
    }
    EXPECT_TRUE(says(drawingOf({}, kPage, "studio"), "no data"));
}

TEST(Drawing, SurvivesWhatIsUnusual) {
    std::vector<Chart> charts = {single({3}, {4}),
                                 single({0, 1}, {5, 5}),
                                 single({0, 1}, {0, 0}),
                                 single({2, 2}, {0, 1}),
                                 single({0, 1}, {-1e300, 1e300}),
                                 single({0, 1e-300}, {1e-320, 0}),
                                 single({0, 1}, {1e9, 1e9 + 1e-7}),
                                 single({1, 0, 1}, {1, 2, 3})};
    for (const PictureSize size : {kPage, PictureSize{1, 1}, {16384, 9}, {9, 2000}}) {
        for (const Chart& chart : charts) {
            EXPECT_TRUE(hasData(chart));
            const Drawing drawing = drawingOf({chart}, size, "print");
            EXPECT_TRUE(isWellFormed(svgOf(drawing)));
            EXPECT_EQ(imageOf(drawing).width, size.width);
        }
        EXPECT_TRUE(isWellFormed(svgOf(charts, size, "dark")));
        imageOf(charts, size, "dark");
    }
}

TEST(Svg, EscapesWhatXmlWouldMisread) {
    Chart chart = single({0, 1}, {0, 1});
    chart.title = "a < b & \"c\" > 'd'";
    chart.series[0].label = std::string("tab\tand \x1b[31m and \xff") + "</text>";
    const std::string svg = svgOf({chart}, kPage, "studio");
    EXPECT_NE(svg.find("a &lt; b &amp; &quot;c&quot; &gt; &apos;d&apos;"), std::string::npos);
    EXPECT_EQ(count(svg, "</text>"), count(svg, "<text "));
    EXPECT_TRUE(isWellFormed(svg)) << svg;
    EXPECT_FALSE(isWellFormed("<svg><g></svg>"));
    EXPECT_FALSE(isWellFormed("<svg>a < b</svg>"));
}

TEST(Svg, HasOneElementForEveryPrimitive) {
    const Drawing drawing = drawingOf({waves(), manyEnds(12)}, kPage, "studio");
    const std::string svg = svgOf(drawing);
    EXPECT_EQ(count(svg, "<rect "), static_cast<int>(drawing.rectangles.size()));
    EXPECT_EQ(count(svg, "<path "), static_cast<int>(drawing.lines.size()));
    EXPECT_EQ(count(svg, "<text "), static_cast<int>(drawing.labels.size()));
    EXPECT_NE(svg.find("viewBox=\"0 0 1280 720\""), std::string::npos);
    EXPECT_NE(svg.find("font-family=\"Inter, DejaVu Sans, sans-serif\""), std::string::npos);
}

int colored(const render::Image& image, const render::Color& color) {
    int found = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4)
        found += std::abs(image.pixels[i] - 255 * color.r) < 2 &&
                 std::abs(image.pixels[i + 1] - 255 * color.g) < 2 &&
                 std::abs(image.pixels[i + 2] - 255 * color.b) < 2;
    return found;
}

/// Leaving a primitive out must change the pixels, as it changes the elements of the SVG.
TEST(Picture, DrawsEveryPrimitive) {
    const Drawing whole = drawingOf({waves()}, kPage, "print");
    const render::Image image = imageOf(whole);
    for (std::size_t i = 0; i < whole.lines.size(); ++i) {
        Drawing less = whole;
        less.lines.erase(less.lines.begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_NE(imageOf(less).pixels, image.pixels) << "line " << i;
    }
    for (std::size_t i = 0; i < whole.labels.size(); ++i) {
        Drawing less = whole;
        less.labels.erase(less.labels.begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_NE(imageOf(less).pixels, image.pixels) << whole.labels[i].text;
    }
    EXPECT_GT(colored(image, lineColor(0, inksOf("print"))), 500);
    EXPECT_GT(colored(image, inksOf("print").ground), 800000);
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) ASSERT_EQ(image.pixels[i], 255);
}

TEST(Picture, IsTheSameEveryTime) {
    EXPECT_EQ(imageOf({waves()}, kPage, "dark").pixels, imageOf({waves()}, kPage, "dark").pixels);
    EXPECT_EQ(svgOf({waves()}, kPage, "dark"), svgOf({waves()}, kPage, "dark"));
}

}  // namespace
}  // namespace demos
