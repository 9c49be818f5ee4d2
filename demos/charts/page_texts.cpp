#include "demos/charts/page_texts.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/charts/curve.h"
#include "demos/text/complaints.h"
#include "render/corners.h"
#include "render/overlay.h"

namespace demos {
namespace {

constexpr std::size_t kMostEndLabels = 5;  // on paper; more would take the chart's whole height
constexpr float kLabelShare = 0.2f;       // of the width: the limit of end labels
constexpr float kSample = 2.2f;            // of a legend's sample with its gap, in text heights

std::string withUnit(const std::string& title, const std::string& unit) {
    return printable(unit.empty() ? title : title + " (" + unit + ")");
}

/// On paper as many lines as needed; on a screen one line, shortened if necessary.
std::vector<std::string> linesOf(const std::string& text, float pixels, float room,
                                 const Page& page) {
    if (text.empty()) return {};
    if (!page.onPaper || page.low) return {fitted(text, pixels, room)};
    return render::brokenText(text, static_cast<int>(pixels), room);
}

/// Asides are removed first: the caption has them.
std::vector<std::string> titleLines(const std::string& text, const Page& page, float room) {
    if (text.empty()) return {};
    return linesOf(withoutAsides(text, page.title, room), page.title, room, page);
}

/// "solver.type: 1 impulses, 2 pgs", if names have no room at the ticks.
std::string numberedNames(const std::string& title, const std::vector<std::string>& names) {
    std::string text = title + ":";
    for (std::size_t i = 0; i < names.size(); ++i)
        text += fmt::format("{} {} {}", i == 0 ? "" : ",", i + 1, printable(names[i]));
    return text;
}

/// An estimate before the labels are placed, on the safe side.
bool namesFit(const Chart& chart, const Page& page, float width) {
    const float room = width - 2.0f * page.margin - 6.0f * page.text;
    const float each = room / static_cast<float>(std::max<std::size_t>(chart.xNames.size(), 1));
    return std::all_of(chart.xNames.begin(), chart.xNames.end(), [&](const std::string& name) {
        return render::textWidth(printable(name), page.text) + 0.6f * page.text <= each;
    });
}

bool needsLegend(const std::vector<EndLabel>& labels, const Page& page, float width) {
    if (!page.onPaper || page.low || labels.empty()) return false;
    float widest = 0.0f;
    for (const EndLabel& label : labels)
        widest = std::max(widest, render::textWidth(label.text, page.text));
    return labels.size() > kMostEndLabels || widest + 1.7f * page.text > kLabelShare * width;
}

/// In columns as wide as the longest name.
std::vector<LegendEntry> legendOf(const std::vector<EndLabel>& labels, const Page& page,
                                  float room) {
    std::vector<LegendEntry> legend;
    float widest = 0.0f;
    for (const EndLabel& label : labels) {
        const std::string text = fittedName(label.text, page.text, room - kSample * page.text);
        widest = std::max(widest, kSample * page.text + render::textWidth(text, page.text));
        legend.push_back({label.series, text, 0.0f, 0});
    }
    const float gap = 1.2f * page.text;
    const int columns = std::max(static_cast<int>((room + gap) / (widest + gap)), 1);
    for (int i = 0; i < static_cast<int>(legend.size()); ++i) {
        legend[i].x = static_cast<float>(i % columns) * (widest + gap);
        legend[i].row = i / columns;
    }
    return legend;
}

float rowsBeyond(std::size_t lines, float pixels) {
    return lines > 1 ? kRow * pixels * static_cast<float>(lines - 1) : 0.0f;
}

}  // namespace

int lastDrawn(const Chart& chart, const Series& series) {
    std::size_t last = std::min(series.x.size(), series.y.size());
    while (last > 0 && !isDrawable(chart, series, last - 1)) --last;
    return static_cast<int>(last) - 1;
}

std::vector<EndLabel> labelsOf(const Chart& chart) {
    std::vector<EndLabel> labels;
    for (int i = 0; i < static_cast<int>(chart.series.size()); ++i) {
        const Series& series = chart.series[i];
        if (!series.label.empty() && lastDrawn(chart, series) >= 0)
            labels.push_back({i, printable(series.label), 0.0f, 0.0f});
    }
    return labels;
}

void setTexts(const Chart& chart, const std::string& note, const Page& page, float width,
              Plot& plot) {
    const float room = width - 2.0f * page.margin;
    const std::string y = withUnit(chart.yTitle, chart.yUnit);
    plot.title = titleLines(printable(chart.title), page, room);
    plot.yTitle =
        linesOf(y + (y.empty() || note.empty() ? "" : " · ") + note, page.text, room, page);
    plot.xTitleBelow = page.onPaper && !page.low;
    std::string x = withUnit(chart.xTitle, chart.xUnit);
    plot.numbered = plot.xTitleBelow && !namesFit(chart, page, width);
    if (plot.numbered) x = numberedNames(x, chart.xNames);
    plot.xTitle = plot.xTitleBelow ? linesOf(x, page.text, room, page)
                  : x.empty()      ? std::vector<std::string>{}
                                   : std::vector<std::string>{x};
    const std::vector<EndLabel> labels = labelsOf(chart);
    if (needsLegend(labels, page, width)) plot.legend = legendOf(labels, page, room);
    const int rows = plot.legend.empty() ? 0 : plot.legend.back().row + 1;
    plot.higher = rowsBeyond(plot.title.size(), page.title) +
                  rowsBeyond(plot.yTitle.size(), page.text) +
                  rowsBeyond(plot.xTitle.size(), page.text) +
                  (rows > 0 ? kRow * page.text * (static_cast<float>(rows) + 0.3f) : 0.0f);
}

}  // namespace demos
