#include "demos/report/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/figure/type.h"
#include "demos/report/curve.h"
#include "demos/scene/complaints.h"
#include "render/overlay.h"

namespace demos {
namespace {

constexpr double kLargest = 1e300, kSmallest = 1e-300;  // beyond, an axis could not be computed
constexpr float kSmallestText = 9.0f;                   // pixels; smaller is not legible
constexpr float kLineSpacing = 1.15f;                   // of end labels, in their height

struct Range {
    double low = kLargest, high = -kLargest;
    bool whole = true;
    void add(double value) {
        low = std::min(low, value), high = std::max(high, value);
        whole = whole && value == std::floor(value);
    }
};

struct Ranges {
    Range x, y;
    bool any = false;
    int zero = 0, negative = 0;  // left out of a log axis
};

/// The x axis reaches over gaps, so that charts of one run can be read below each other.
Ranges rangesOf(const Chart& chart) {
    Ranges ranges;
    for (const Series& series : chart.series)
        for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
            if (std::abs(series.x[i]) <= kLargest) ranges.x.add(series.x[i]);
            if (isDrawable(chart, series, i)) {
                ranges.any = true;
                ranges.y.add(series.y[i]);
            } else if (std::isfinite(series.y[i]) && chart.logY) {
                ++(series.y[i] < 0.0 ? ranges.negative : ranges.zero);
            }
        }
    return ranges;
}

std::string withUnit(const std::string& title, const std::string& unit) {
    return printable(unit.empty() ? title : title + " (" + unit + ")");
}

std::string noteOf(const Ranges& ranges) {
    const int count = ranges.zero + ranges.negative;
    if (count == 0) return {};
    return fmt::format("{} {} of {} not shown", count, count == 1 ? "value" : "values",
                       ranges.negative > 0 ? "0 or below" : "0");
}

float widest(const std::vector<std::string>& texts, float pixels) {
    float most = 0.0f;
    for (const std::string& text : texts) most = std::max(most, render::textWidth(text, pixels));
    return most;
}

/// As many ticks as can be read without crowding.
Axis xAxisOf(const Range& range, float length, float text) {
    Axis axis;
    for (int most = std::clamp(static_cast<int>(length / (2.5f * text)), 1, 10); most >= 1;
         --most) {
        axis = linearAxis(range.low, range.high, most, Reach::data, range.whole);
        const float shares = static_cast<float>(std::max<std::size_t>(axis.ticks.size(), 2) - 1);
        if ((widest(axis.texts, text) + text) * shares <= length) break;
    }
    return axis;
}

Axis yAxisOf(const Chart& chart, const Range& range, float length, float text) {
    const double rows = static_cast<double>(length / text);
    if (chart.logY)
        return logAxis(range.low, range.high, std::clamp(static_cast<int>(rows / 1.5), 1, 8));
    return linearAxis(range.low, range.high, std::clamp(rows / 1.25, 1.0, 7.0), Reach::ticks,
                      range.whole);
}

/// Rows of text and the axes' places, from the top of the chart's share of the page.
void placeRows(Plot& plot, const Page& page, float top, float height, bool hasTitle) {
    plot.titleBase = top + 0.45f * page.margin + page.title;
    plot.yTitleBase = hasTitle ? plot.titleBase + 1.4f * page.text : plot.titleBase;
    plot.top = std::round(plot.yTitleBase + 0.95f * page.text);
    plot.bottom = std::max(std::round(top + height - 2.1f * page.text), plot.top + 1.0f);
    plot.tickBase = plot.bottom + 1.3f * page.text;
}

/// The labels in the order of the series; what has no room is counted in the last.
void chooseLabels(Plot& plot, const Chart& chart, const Page& page) {
    for (int i = 0; i < static_cast<int>(chart.series.size()); ++i) {
        const Series& series = chart.series[i];
        std::size_t last = std::min(series.x.size(), series.y.size());
        while (last > 0 && !isDrawable(chart, series, last - 1)) --last;
        if (last > 0 && !series.label.empty())
            plot.labels.push_back({i, printable(series.label), plot.yOf(series.y[last - 1]), 0.0f});
    }
    const float room = plot.bottom - plot.top;
    const float share =
        room / (kLineSpacing * static_cast<float>(std::max<std::size_t>(plot.labels.size(), 1)));
    plot.labelPixels = std::clamp(std::floor(share), page.leastLabel, page.text);
    const auto most =
        static_cast<std::size_t>(std::max(room / (kLineSpacing * plot.labelPixels), 1.0f));
    if (plot.labels.size() <= most) return;
    const std::size_t left = plot.labels.size() - most + 1;
    plot.labels.resize(most - 1);
    plot.labels.push_back({-1, fmt::format("+ {} more", left), plot.bottom, 0.0f});
}

void separateLabels(Plot& plot) {
    std::vector<float> wanted;
    for (const EndLabel& label : plot.labels) wanted.push_back(label.value);
    const float half = 0.5f * kLineSpacing * plot.labelPixels;
    const std::vector<float> y =
        separated(wanted, 2.0f * half, plot.top + half - 0.4f * half, plot.bottom - 0.6f * half);
    for (std::size_t i = 0; i < y.size(); ++i) plot.labels[i].y = y[i];
}

Plot plotOf(const Chart& chart, const Ranges& ranges, const Page& page, float top, float height) {
    Plot plot;
    placeRows(plot, page, top, height, !chart.title.empty());
    plot.empty = !ranges.any;
    plot.xText = withUnit(chart.xTitle, chart.xUnit);
    plot.yText = withUnit(chart.yTitle, chart.yUnit);
    const std::string note = noteOf(ranges);
    if (!note.empty()) plot.yText += (plot.yText.empty() ? "" : " · ") + note;
    if (plot.empty) return plot;
    plot.y = yAxisOf(chart, ranges.y, plot.bottom - plot.top, page.text);
    chooseLabels(plot, chart, page);
    separateLabels(plot);
    return plot;
}

/// Letters and lines, by the page's size or in points; `height`: pixels a chart.
Page emptyPage(float width, float height, const Paper& paper) {
    Page page;
    if (paper.given()) {
        const double scale = paper.pixelsPerPoint();
        page.unit = static_cast<float>(kCurvePoints * scale) / kLineWidth;
        page.text = static_cast<float>(letterPixels(kLabelPoints, scale));
        page.title = static_cast<float>(letterPixels(kTitlePoints, scale));
        page.leastLabel = page.text;
        page.onPaper = true;
    } else {
        page.unit = static_cast<float>(paper.type) * std::min(width / 1280.0f, height / 240.0f);
        page.text = std::max(std::round(20.0f * page.unit), kSmallestText);
        page.title = std::round(1.3f * page.text);
        page.leastLabel = std::max(std::round(0.7f * page.text), kSmallestText);
    }
    page.margin = 0.9f * page.text;
    return page;
}

/// What stands to the right of the lines: labels, and the x axis's title beside its ticks.
float rightRoom(const Plot& plot, const Page& page) {
    float room = plot.xText.empty() ? page.text
                                    : 2.4f * page.text + render::textWidth(plot.xText, page.text);
    for (const EndLabel& label : plot.labels)
        room = std::max(room, 1.7f * page.text + render::textWidth(label.text, plot.labelPixels));
    return room;
}

}  // namespace

bool isDrawable(const Chart& chart, const Series& series, std::size_t sample) {
    const double x = series.x[sample], y = series.y[sample];
    if (!(std::abs(x) <= kLargest && std::abs(y) <= kLargest)) return false;
    return !chart.logY || y >= kSmallest;
}

Page pageOf(const std::vector<Chart>& charts, PictureSize size, const Paper& paper) {
    const float width = static_cast<float>(size.width);
    const float height = static_cast<float>(size.height) /
                         static_cast<float>(std::max<std::size_t>(charts.size(), 1));
    Page page = emptyPage(width, height, paper);
    std::vector<Ranges> ranges;
    float left = 0.0f, right = 0.0f;
    for (std::size_t i = 0; i < charts.size(); ++i) {
        ranges.push_back(rangesOf(charts[i]));
        page.plots.push_back(
            plotOf(charts[i], ranges[i], page, static_cast<float>(i) * height, height));
        left = std::max(left, widest(page.plots[i].y.texts, page.text) + 0.6f * page.text);
        right = std::max(right, rightRoom(page.plots[i], page));
    }
    right = std::min(right, (paper.type > 1.0 ? 0.4f : 0.3f) * width);
    for (std::size_t i = 0; i < charts.size(); ++i) {
        Plot& plot = page.plots[i];
        plot.left = std::round(page.margin + left);
        plot.right = std::max(std::round(width - page.margin - right), plot.left + 1.0f);
        if (!plot.empty) plot.x = xAxisOf(ranges[i].x, plot.right - plot.left, page.text);
        for (EndLabel& label : plot.labels)
            label.text = fitted(label.text, plot.labelPixels,
                                width - plot.right - page.margin - 1.4f * page.text);
    }
    return page;
}

}  // namespace demos
