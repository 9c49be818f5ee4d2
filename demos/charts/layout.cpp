#include "demos/charts/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "demos/charts/curve.h"
#include "demos/charts/page_texts.h"
#include "demos/look/type.h"
#include "demos/text/complaints.h"
#include "render/overlay.h"

namespace demos {
namespace {

constexpr double kLargest = 1e300, kSmallest = 1e-300;  // limits of what an axis can show
constexpr float kSmallestText = 9.0f;                   // pixels; smaller is not legible
constexpr float kLineSpacing = 1.15f;                   // of end labels, times their height

struct DataRange {
    double low = kLargest, high = -kLargest;
    bool whole = true;
    void add(double value) {
        low = std::min(low, value), high = std::max(high, value);
        whole = whole && value == std::floor(value);
    }
};

struct Ranges {
    DataRange x, y;
    bool any = false;
    int zero = 0, negative = 0, tiny = 0;  // left out of a log axis
};

/// The x axis includes gaps, so that charts of one run are aligned below each other.
Ranges rangesOf(const Chart& chart) {
    Ranges ranges;
    for (const Series& series : chart.series)
        for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
            if (std::abs(series.x[i]) <= kLargest) ranges.x.add(series.x[i]);
            if (isDrawable(chart, series, i)) {
                ranges.any = true;
                ranges.y.add(series.y[i]);
            } else if (std::isfinite(series.y[i]) && chart.logY) {
                const double y = series.y[i];
                ++(y < 0.0 ? ranges.negative : y < kSmallest ? ranges.zero : ranges.tiny);
            }
        }
    return ranges;
}

std::string noteOf(const Ranges& ranges) {
    const int count = ranges.zero + ranges.negative + ranges.tiny;
    if (count == 0) return {};
    return fmt::format("{} {} of {} not shown", count, count == 1 ? "value" : "values",
                       ranges.negative > 0 ? "0 or below"
                       : ranges.tiny > 0   ? "nearly 0"
                                           : "0");
}

float widest(const std::vector<std::string>& texts, float pixels) {
    float most = 0.0f;
    for (const std::string& text : texts) most = std::max(most, render::textWidth(text, pixels));
    return most;
}

/// Labels the ends of the range if there are no round values between them.
void addEnds(const DataRange& range, Axis& axis) {
    axis.ticks = {range.low, range.high};
    axis.texts = {fmt::format("{:.3g}", range.low), fmt::format("{:.3g}", range.high)};
}

/// A range that begins near 0, such as with the first step's time, is extended to 0.
Axis linearXAxis(DataRange range, float length, float text) {
    if (!range.whole && range.low > 0.0 && range.low < 0.05 * range.high) range.low = 0.0;
    Axis axis;
    for (int most = std::clamp(static_cast<int>(length / (2.5f * text)), 1, 10); most >= 1;
         --most) {
        axis = linearAxis(range.low, range.high, most, Reach::data, range.whole);
        const float shares = static_cast<float>(std::max<std::size_t>(axis.ticks.size(), 2) - 1);
        if ((widest(axis.texts, text) + text) * shares <= length) break;
    }
    if (axis.ticks.size() < 2 && range.low < range.high) addEnds(range, axis);
    return axis;
}

/// A tick at every value; if they are crowded, only every second, third, ... has a number.
Axis logXAxis(const Chart& chart, const DataRange& range, float length, float text) {
    std::set<double> values;
    for (const Series& series : chart.series)
        for (const double x : series.x)
            if (x >= range.low && x <= range.high) values.insert(x);
    const std::vector<double> all(values.begin(), values.end());
    Axis axis;
    axis.low = range.low, axis.high = range.high, axis.log = true;
    for (std::size_t every = 1; every <= all.size(); ++every) {
        axis.ticks.clear(), axis.texts.clear();
        for (std::size_t i = 0; i < all.size(); ++i) {
            axis.ticks.push_back(all[i]);
            axis.texts.push_back(i % every == 0 ? fmt::format("{:.6g}", all[i]) : "");
        }
        const float shares = static_cast<float>(all.size() - 1) / static_cast<float>(every);
        if ((widest(axis.texts, text) + 0.6f * text) * shares <= length) break;
    }
    return axis;
}

/// Half a place is left free on both sides.
Axis namedXAxis(const Chart& chart, bool numbered, float length, float text) {
    Axis axis;
    const std::size_t count = chart.xNames.size();
    axis.low = -0.5, axis.high = static_cast<double>(count) - 0.5;
    const float room = length / static_cast<float>(count) - 0.4f * text;
    for (std::size_t i = 0; i < count; ++i) {
        axis.ticks.push_back(static_cast<double>(i));
        axis.texts.push_back(numbered ? std::to_string(i + 1)
                                      : fittedName(printable(chart.xNames[i]), text, room));
    }
    return axis;
}

Axis xAxisOf(const Chart& chart, const DataRange& range, const Plot& plot, float text) {
    const float length = plot.right - plot.left;
    if (!chart.xNames.empty()) return namedXAxis(chart, plot.numbered, length, text);
    if (chart.logX && range.low > 0.0 && range.low < range.high)
        return logXAxis(chart, range, length, text);
    return linearXAxis(range, length, text);
}

Axis yAxisOf(const Chart& chart, const DataRange& range, float length, float text) {
    const double rows = static_cast<double>(length / text);
    if (chart.logY)
        return logAxis(range.low, range.high, std::clamp(static_cast<int>(rows / 1.5), 1, 8));
    return linearAxis(range.low, range.high, std::clamp(rows / 1.25, 1.0, 7.0), Reach::ticks,
                      range.whole);
}

/// The positions of text rows and axes, from the top of the chart's part of the page.
void placeRows(Plot& plot, const Page& page, float top, float height) {
    const auto rows = [](std::size_t lines, float pixels) {
        return kRow * pixels * static_cast<float>(std::max<std::size_t>(lines, 1) - 1);
    };
    plot.titleBase = top + 0.45f * page.margin + page.title;
    const float titleEnd = plot.titleBase + rows(plot.title.size(), page.title);
    plot.yTitleBase = plot.title.empty() ? titleEnd : titleEnd + 1.4f * page.text;
    plot.top = std::round(plot.yTitleBase + rows(plot.yTitle.size(), page.text) +
                          0.95f * page.text);
    const int legendRows = plot.legend.empty() ? 0 : plot.legend.back().row + 1;
    const float legend = legendRows > 0 ? (static_cast<float>(legendRows) + 0.3f) * kRow : 0.0f;
    const float titles = plot.xTitleBelow ? kRow * static_cast<float>(plot.xTitle.size()) : 0.0f;
    plot.bottom = std::max(std::round(top + height - (2.1f + titles + legend) * page.text),
                           plot.top + 1.0f);
    plot.tickBase = plot.bottom + 1.3f * page.text;
    plot.xTitleBase = plot.tickBase + kRow * page.text;
    plot.legendBase = plot.tickBase + (titles + 1.3f * kRow) * page.text;
}

/// The labels in the order of the series; the last one counts those without room.
void chooseLabels(Plot& plot, const Chart& chart, const Page& page) {
    plot.labels = labelsOf(chart);
    for (EndLabel& label : plot.labels) {
        const Series& series = chart.series[label.series];
        label.value = plot.yOf(series.y[lastDrawn(chart, series)]);
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

/// Places a plot whose texts are set.
void placePlot(const Chart& chart, const Ranges& ranges, const Page& page, float top, float height,
               Plot& plot) {
    placeRows(plot, page, top, height);
    plot.empty = !ranges.any;
    if (plot.empty) return;
    plot.y = yAxisOf(chart, ranges.y, plot.bottom - plot.top, page.text);
    if (!plot.legend.empty()) return;
    chooseLabels(plot, chart, page);
    separateLabels(plot);
}

/// Sizes of letters and lines, by the page's size or in points; `height`: pixels per chart.
Page emptyPage(float width, float height, const Paper& paper) {
    Page page;
    if (paper.given()) {
        const double scale = paper.pixelsPerPoint();
        page.unit = static_cast<float>(kCurvePoints * scale) / kLineWidth;
        page.text = static_cast<float>(letterPixels(kLabelPoints, scale));
        page.title = static_cast<float>(letterPixels(kTitlePoints, scale));
        page.leastLabel = page.text;
        page.onPaper = true;
        page.low = height < 9.0f * page.text;
    } else {
        page.unit = static_cast<float>(paper.type) * std::min(width / 1280.0f, height / 240.0f);
        page.text = std::max(std::round(20.0f * page.unit), kSmallestText);
        page.title = std::round(1.3f * page.text);
        page.leastLabel = std::max(std::round(0.7f * page.text), kSmallestText);
    }
    page.margin = 0.9f * page.text;
    return page;
}

/// The room to the right of the lines, for labels, and for the x axis's title if it is next to the
/// ticks.
float rightRoom(const Plot& plot, const Page& page) {
    float room = plot.xTitleBelow      ? 0.6f * page.text
                 : plot.xTitle.empty() ? page.text
                                       : 2.4f * page.text +
                                             render::textWidth(plot.xTitle.front(), page.text);
    for (const EndLabel& label : plot.labels)
        room = std::max(room, 1.7f * page.text + render::textWidth(label.text, plot.labelPixels));
    return room;
}

void placeColumns(const std::vector<Chart>& charts, const std::vector<Ranges>& ranges, float width,
                  float mostRight, Page& page) {
    float left = 0.0f, right = 0.0f;
    for (const Plot& plot : page.plots) {
        left = std::max(left, widest(plot.y.texts, page.text) + 0.6f * page.text);
        right = std::max(right, rightRoom(plot, page));
    }
    right = std::min(right, mostRight);
    for (std::size_t i = 0; i < charts.size(); ++i) {
        Plot& plot = page.plots[i];
        plot.left = std::round(page.margin + left);
        plot.right = std::max(std::round(width - page.margin - right), plot.left + 1.0f);
        if (!plot.empty) plot.x = xAxisOf(charts[i], ranges[i].x, plot, page.text);
        for (EndLabel& label : plot.labels)
            label.text = fittedName(label.text, plot.labelPixels,
                                    width - plot.right - page.margin - 1.4f * page.text);
    }
}

}  // namespace

bool isDrawable(const Chart& chart, const Series& series, std::size_t sample) {
    const double x = series.x[sample], y = series.y[sample];
    if (!(std::abs(x) <= kLargest && std::abs(y) <= kLargest)) return false;
    return !chart.logY || y >= std::max(kSmallest, chart.leastY);
}

/// All plots are equally high: a chart whose texts take more lines is higher by that.
Page pageOf(const std::vector<Chart>& charts, PictureSize size, const Paper& paper) {
    const float width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    const float count = static_cast<float>(std::max<std::size_t>(charts.size(), 1));
    Page page = emptyPage(width, height / count, paper);
    std::vector<Ranges> ranges;
    float higher = 0.0f;
    for (const Chart& chart : charts) {
        ranges.push_back(rangesOf(chart));
        page.plots.emplace_back();
        setTexts(chart, noteOf(ranges.back()), page, width, page.plots.back());
        higher += page.plots.back().higher;
    }
    float top = 0.0f;
    for (std::size_t i = 0; i < charts.size(); ++i) {
        const float own = (height - higher) / count + page.plots[i].higher;
        placePlot(charts[i], ranges[i], page, top, own, page.plots[i]);
        top += own;
    }
    placeColumns(charts, ranges, width, (paper.type > 1.0 ? 0.4f : 0.3f) * width, page);
    return page;
}

}  // namespace demos
