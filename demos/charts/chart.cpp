#include "demos/charts/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/charts/curve.h"
#include "demos/charts/drawing.h"
#include "demos/charts/layout.h"
#include "demos/charts/page_texts.h"
#include "demos/look/inks.h"
#include "demos/text/stop.h"
#include "render/overlay.h"

namespace demos {
namespace {

using render::Anchor;
using render::Point;

constexpr float kMiddle =
    0.31f;  // of a text's height: from the middle of its digits to the baseline

/// Draws the charts of a page.
class Pen {
public:
    Pen(const Page& page, PictureSize size, const std::string& theme)
        : page_(page), inks_(inksOf(theme)), width_(static_cast<float>(size.width)) {
        drawing_.size = size;
        if (theme != "transparent")
            add(Rectangle{{0, 0}, width_, static_cast<float>(size.height), inks_.ground});
    }

    void draw(const Chart& chart, const Plot& plot) {
        drawTitles(plot);
        drawGrid(plot);
        if (plot.empty) return drawNoData(plot);
        drawTicks(plot);
        for (std::size_t i = 0; i < chart.series.size(); ++i)
            drawSeries(chart, plot, static_cast<int>(i));
        drawXTitle(plot);
        for (const EndLabel& label : plot.labels) drawEndLabel(chart, plot, label);
        drawLegend(chart, plot);
    }
    Drawing finish() { return std::move(drawing_); }

private:
    void add(Rectangle rectangle) { drawing_.rectangles.push_back(rectangle); }
    void add(std::vector<Point> points, float width, const render::Color& color) {
        drawing_.lines.push_back({std::move(points), width, color});
    }
    /// Ignores an empty text, so that all labels have ink.
    void add(std::string text, Point at, Anchor anchor, float pixels, const render::Color& color) {
        if (!text.empty()) drawing_.labels.push_back({std::move(text), at, anchor, pixels, color});
    }
    float hair() const { return std::max(std::round(1.2f * page_.unit), 1.0f); }
    float lineWidth() const {
        return page_.onPaper ? kLineWidth * page_.unit : std::max(kLineWidth * page_.unit, 1.4f);
    }
    void addLines(const std::vector<std::string>& lines, float pixels, Point at,
                  const render::Color& color) {
        for (const std::string& line : lines) {
            add(line, at, Anchor::start, pixels, color);
            at.y += kRow * pixels;
        }
    }

    void drawTitles(const Plot& plot) {
        addLines(plot.title, page_.title, {page_.margin, plot.titleBase}, inks_.ink);
        addLines(plot.yTitle, page_.text, {page_.margin, plot.yTitleBase}, inks_.muted);
    }

    void drawGrid(const Plot& plot) {
        const float length = plot.right - plot.left;
        for (const double tick : plot.y.ticks) {
            const bool zero = tick == 0.0 && !plot.y.log;
            add(Rectangle{{plot.left, std::round(plot.yOf(tick))},
                          length,
                          hair(),
                          zero ? inks_.axis : inks_.grid});
        }
        add(Rectangle{{plot.left, plot.bottom}, length, hair(), inks_.axis});
    }

    void drawTicks(const Plot& plot) {
        for (std::size_t i = 0; i < plot.y.ticks.size(); ++i)
            add(plot.y.texts[i],
                {plot.left - 0.5f * page_.text, plot.yOf(plot.y.ticks[i]) + kMiddle * page_.text},
                Anchor::end, page_.text, inks_.muted);
        float end = plot.right;
        for (std::size_t i = 0; i < plot.x.ticks.size(); ++i) {
            const float x = plot.xOf(plot.x.ticks[i]);
            add(Rectangle{{std::round(x), plot.bottom}, hair(), 0.28f * page_.text, inks_.axis});
            add(plot.x.texts[i], {x, plot.tickBase}, Anchor::middle, page_.text, inks_.muted);
            end = std::max(end, x + 0.5f * render::textWidth(plot.x.texts[i], page_.text));
        }
        if (!plot.xTitleBelow && !plot.xTitle.empty()) {
            end += 0.6f * page_.text;
            add(fitted(plot.xTitle.front(), page_.text, width_ - 0.5f * page_.margin - end),
                {end, plot.tickBase}, Anchor::start, page_.text, inks_.muted);
        }
    }

    /// Below the middle of the axis if there is room; several lines begin at the margin.
    void drawXTitle(const Plot& plot) {
        if (!plot.xTitleBelow || plot.xTitle.empty()) return;
        if (plot.xTitle.size() > 1)
            return addLines(plot.xTitle, page_.text, {page_.margin, plot.xTitleBase}, inks_.muted);
        const float half = 0.5f * render::textWidth(plot.xTitle.front(), page_.text);
        const float x = std::min(0.5f * (plot.left + plot.right), width_ - page_.margin - half);
        add(plot.xTitle.front(), {std::max(x, page_.margin + half), plot.xTitleBase},
            Anchor::middle, page_.text, inks_.muted);
    }

    void drawLegend(const Chart& chart, const Plot& plot) {
        for (const LegendEntry& entry : plot.legend) {
            const int ink = inkOf(chart, entry.series);
            const float x = page_.margin + entry.x;
            const float y = plot.legendBase + kRow * page_.text * static_cast<float>(entry.row);
            const float middle = y - kMiddle * page_.text;
            if (chart.xNames.empty())
                add({{x, middle}, {x + 1.6f * page_.text, middle}}, lineWidth(),
                    lineColor(ink, inks_));
            else
                add({{x + 0.8f * page_.text, middle}}, 4.5f * lineWidth(), lineColor(ink, inks_));
            add(entry.text, {x + 2.2f * page_.text, y}, Anchor::start, page_.text,
                labelColor(ink, inks_));
        }
    }

    static int inkOf(const Chart& chart, int series) {
        const int own = chart.series[static_cast<std::size_t>(series)].ink;
        return own >= 0 ? own : series;
    }

    void drawNoData(const Plot& plot) {
        add("no data",
            {0.5f * (plot.left + plot.right),
             0.5f * (plot.top + plot.bottom) + kMiddle * page_.title},
            Anchor::middle, page_.title, inks_.muted);
    }

    /// Draws the pieces between gaps; if there are few samples, each is marked by a dot.
    void drawSeries(const Chart& chart, const Plot& plot, int number) {
        const Series& series = chart.series[number];
        const render::Color color = lineColor(inkOf(chart, number), inks_);
        std::vector<Point> piece, all;
        const std::size_t count = std::min(series.x.size(), series.y.size());
        for (std::size_t i = 0; i <= count; ++i) {
            if (i < count && isDrawable(chart, series, i)) {
                piece.push_back({plot.xOf(series.x[i]), plot.yOf(series.y[i])});
                all.push_back(piece.back());
            } else if (!piece.empty()) {
                if (chart.xNames.empty())
                    add(thinned(piece), (piece.size() == 1 ? 2.2f : 1.0f) * lineWidth(), color);
                piece.clear();
            }
        }
        const bool named = !chart.xNames.empty();
        if (named || areApart(all, 5.0f * lineWidth()))
            for (const Point& point : all)
                add({point}, (named ? 4.5f : 2.6f) * lineWidth(), color);
    }

    /// On average, and if there are at least two.
    static bool areApart(const std::vector<Point>& points, float pixels) {
        const float steps = static_cast<float>(points.size()) - 1.0f;
        return points.size() > 1 && points.back().x - points.front().x > steps * pixels;
    }

    void drawEndLabel(const Chart& chart, const Plot& plot, const EndLabel& label) {
        const float x = plot.right + 1.4f * page_.text;
        const bool isLine = label.series >= 0;
        add(label.text, {x, label.y + kMiddle * plot.labelPixels}, Anchor::start, plot.labelPixels,
            isLine ? labelColor(inkOf(chart, label.series), inks_) : inks_.muted);
        if (!isLine || !endsAtTheRight(chart, plot, label.series)) return;
        render::Color color = lineColor(inkOf(chart, label.series), inks_);
        color.a = 0.75f;
        add({{plot.right + 0.45f * page_.text, label.value}, {x - 0.35f * page_.text, label.y}},
            0.5f * lineWidth(), color);
    }

    bool endsAtTheRight(const Chart& chart, const Plot& plot, int number) const {
        const Series& series = chart.series[number];
        for (std::size_t i = std::min(series.x.size(), series.y.size()); i-- > 0;)
            if (isDrawable(chart, series, i)) return plot.xOf(series.x[i]) > plot.right - 3.0f;
        return false;
    }

    const Page& page_;
    Inks inks_;
    float width_;  // pixels, of the page
    Drawing drawing_;
};

constexpr double kLeastChart = 40.0;  // mm: ticks with their numbers, and a plot of the same width
constexpr double kLeastAsked = 30.0;  // mm of a chart's height where --size sets it

void checkChartWidth(const Paper& paper) {
    if (paper.width < kLeastChart)
        throw Stop(Exit::usage, fmt::format("--width {:g}mm: a chart needs {:g}mm or more",
                                            paper.width, kLeastChart));
}

PictureSize askedSize(double charts, const Paper& paper, PictureSize ratio) {
    const PictureSize size = figureSize(paper, ratio);
    const double each = paper.millimetresOf(size.height) / charts;
    if (each < kLeastAsked)
        throw Stop(Exit::usage,
                   fmt::format("--size {}x{}: {:g} {} of {:.1f} mm height in a width of {:g} mm; "
                               "each needs {:g} mm: use --size {}x{:.0f} or higher, or omit it",
                               ratio.width, ratio.height, charts, charts > 1 ? "charts" : "chart",
                               each, paper.width, kLeastAsked, ratio.width,
                               std::ceil(kLeastAsked * charts / paper.width * ratio.width)));
    return size;
}

}  // namespace

bool hasData(const Chart& chart) {
    for (const Series& series : chart.series)
        for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i)
            if (isDrawable(chart, series, i)) return true;
    return false;
}

PictureSize chartSize(std::size_t count) {
    const int most = 16384;  // the limit of a picture
    const int charts = static_cast<int>(std::min<std::size_t>(std::max<std::size_t>(count, 1), 40));
    return {1280, std::min(std::max(360 * charts, 720), most)};
}

PictureSize chartSize(std::size_t count, const Paper& paper, std::optional<PictureSize> ratio) {
    constexpr double kLeast = 38.0;  // mm per chart: one and a half times its titles and ticks
    const double charts = static_cast<double>(std::max<std::size_t>(count, 1));
    checkChartWidth(paper);
    if (ratio) return askedSize(charts, paper, *ratio);
    const double each = std::max((charts > 1 ? 9.0 / 32.0 : 9.0 / 16.0) * paper.width, kLeast);
    return figureSize(paper, {paper.pixels(), paper.pixelsOf(charts * each)});
}

PictureSize chartSize(const std::vector<Chart>& charts, const Paper& paper,
                      std::optional<PictureSize> ratio) {
    PictureSize size = chartSize(charts.size(), paper, ratio);
    if (ratio) return size;
    float higher = 0.0f;
    for (const Plot& plot : pageOf(charts, size, paper).plots) higher += plot.higher;
    size.height += static_cast<int>(std::lround(higher));
    return figureSize(paper, size);
}

PictureSize chartBelow(const Paper& paper) {
    const PictureSize two = chartSize(2, paper, std::nullopt);
    return {two.width, two.height / 2};
}

Drawing drawingOf(const std::vector<Chart>& charts, PictureSize size, const std::string& theme,
                  const Paper& paper) {
    if (charts.empty()) return drawingOf({Chart{}}, size, theme, paper);
    const Page page = pageOf(charts, size, paper);
    Pen pen(page, size, theme);
    for (std::size_t i = 0; i < charts.size(); ++i) pen.draw(charts[i], page.plots[i]);
    Drawing drawing = pen.finish();
    drawing.millimetres = paper.width;
    drawing.pixelsPerPoint = paper.pixelsPerPoint();
    return drawing;
}

}  // namespace demos
