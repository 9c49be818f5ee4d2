#include "demos/comparisons/measure_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "demos/charts/fitting_unit.h"
#include "demos/film/progress.h"
#include "demos/text/complaints.h"
#include "demos/text/plural.h"

namespace demos {
namespace {

/// Four digits; below 1e-4 six decimals instead of a power of ten, as long as they show something.
std::string shortText(double value) {
    if (value == 0.0 || std::abs(value) >= 1e-4 || std::abs(value) < 1e-5)
        return fmt::format("{:.4g}", value);
    return fmt::format("{:.6f}", value);
}

/// What a run of double precision leaves of nothing, in any unit: a joint is not open by a nanometre.
constexpr double kNoise = 1e-8;

/// The value of a measure in a run, without noise.
double valueIn(const Measured& run, std::size_t measure) {
    const double value = run.summary.values[measure];
    return std::isfinite(value) ? std::round(value / kNoise) * kNoise : value;
}

/// Lengths are shown in mm: 0.03 mm is easier to read than 3e-05 m.
FittingUnit shownUnit(const Measure& measure) {
    if (std::string(measure.unit) == "m") return {1e3, "mm"};
    return {1.0, measure.unit};
}

/// The one unit of a measure in all runs of a table.
FittingUnit unitOf(const std::vector<Measured>& runs, std::size_t measure) {
    const FittingUnit shown = shownUnit(measures()[measure]);
    double largest = 0.0;
    for (const Measured& run : runs)
        if (const double x = std::abs(valueIn(run, measure)); std::isfinite(x))
            largest = std::max(largest, shown.scale * x);
    const FittingUnit fitting = fittingUnit(shown.name, largest);
    return {shown.scale * fitting.scale, fitting.name};
}

/// The energy of a run is shown as its change; pictures and plots of one run show it as it is.
std::string heading(const Measure& measure, const FittingUnit& unit) {
    const bool named = unit.name.empty() || unit.name == measure.name;
    const std::string name =
        std::string(measure.name) == "energy" ? "energy change" : measure.name;
    return named ? name : fmt::format("{} ({})", name, unit.name);
}

std::vector<std::size_t> columnsOf(const std::vector<Measured>& runs) {
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < measures().size(); ++i)
        for (const Measured& run : runs)
            if (valueIn(run, i) != 0.0) {
                columns.push_back(i);
                break;
            }
    return columns;
}

double numberOf(const std::string& text) {
    double value = std::numeric_limits<double>::quiet_NaN();
    const char* end = text.data() + text.size();
    const auto got = std::from_chars(text.data(), end, value);
    return got.ptr == end ? value : std::numeric_limits<double>::quiet_NaN();
}

/// The text after the '=' of the run's last setting.
std::string valueOf(const Measured& run) {
    const std::string& setting = run.variant.settings.back();
    return setting.substr(setting.find('=') + 1);
}

/// Whether each value is the same multiple of the one before it, and the last at least 4 times the
/// first.
bool isGeometric(const std::vector<double>& x) {
    if (x.size() < 3 || !(x[0] > 0.0) || !(x[1] >= 1.2 * x[0])) return false;
    const double factor = x[1] / x[0];
    for (std::size_t i = 2; i < x.size(); ++i)
        if (!(std::abs(x[i] - factor * x[i - 1]) < 0.01 * x[i])) return false;
    return x.back() >= 4.0 * x.front();
}

/// The values if all are numbers, else their places in a row of names.
void setValues(const std::vector<Measured>& runs, Chart& chart, Series& series) {
    for (const Measured& run : runs) series.x.push_back(numberOf(valueOf(run)));
    const bool numbers =
        std::all_of(series.x.begin(), series.x.end(), [](double x) { return std::isfinite(x); });
    chart.logX = numbers && isGeometric(series.x);
    if (numbers) return;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        series.x[i] = static_cast<double>(i);
        chart.xNames.push_back(valueOf(runs[i]));
    }
}

/// What is measured at one time: the part of the meaning before "at the end", "at most" or "mean".
std::string meaningAtATime(const Measure& measure) {
    const std::string meaning = measure.meaning;
    return fmt::format("{}: {}", measure.name, meaning.substr(0, meaning.find(',')));
}

std::string csvCell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

/// "LABEL: LINE" of the first run that has such a line, and how many others have one.
std::string firstOf(const std::vector<Measured>& runs, std::string Summary::*line) {
    std::string text;
    std::size_t others = 0;
    for (const Measured& run : runs) {
        if ((run.summary.*line).empty()) continue;
        if (text.empty())
            text = run.variant.label + ": " + run.summary.*line;
        else
            ++others;
    }
    return others == 0 ? text : fmt::format("{}; also {}", text, plural(others, "other run"));
}

}  // namespace

MeasureCells cellsOf(const std::vector<Measured>& runs) {
    const std::vector<std::size_t> columns = columnsOf(runs);
    MeasureCells cells;
    cells.rows.resize(runs.size());
    for (const std::size_t i : columns) {
        const FittingUnit unit = unitOf(runs, i);
        cells.measures.push_back(static_cast<int>(i));
        cells.head.push_back(heading(measures()[i], unit));
        for (std::size_t k = 0; k < runs.size(); ++k)
            cells.rows[k].push_back(shortText(unit.scale * valueIn(runs[k], i)));
    }
    return cells;
}

std::string tableText(const std::vector<Measured>& runs) {
    const MeasureCells cells = cellsOf(runs);
    std::size_t width = 7;
    for (const Measured& run : runs) width = std::max(width, run.variant.label.size());
    std::string text = fmt::format("{:{}}", "variant", width);
    const auto widthOf = [&](std::size_t column) {
        return std::max<std::size_t>(cells.head[column].size(), 16);
    };
    for (const std::string& name : cells.head) text += fmt::format("  {:>16}", name);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        text += fmt::format("\n{:{}}", printable(runs[i].variant.label), width);
        for (std::size_t k = 0; k < cells.rows[i].size(); ++k)
            text += fmt::format("  {:>{}}", cells.rows[i][k], widthOf(k));
        if (!runs[i].summary.diverged.empty()) text += "  diverged";
        if (!runs[i].summary.failed.empty()) text += "  expectation failed";
    }
    return text;
}

std::string incidentLine(const std::vector<Measured>& runs) {
    return firstOf(runs, &Summary::diverged);
}

std::string failedRunsLine(const std::vector<Measured>& runs) {
    return firstOf(runs, &Summary::failed);
}

std::string jsonLine(const Measured& run) {
    std::string text = fmt::format(R"({{"event":"variant","label":{},"settings":[)",
                                   jsonString(run.variant.label));
    for (std::size_t i = 0; i < run.variant.settings.size(); ++i)
        text += (i ? "," : "") + jsonString(run.variant.settings[i]);
    text += "]";
    for (std::size_t i = 0; i < measures().size(); ++i)
        text += fmt::format(",\"{}\":{}", measures()[i].name, numberText(run.summary.values[i]));
    const std::string& diverged = run.summary.diverged;
    const std::string& failed = run.summary.failed;
    return text + ",\"diverged\":" + (diverged.empty() ? "null" : jsonString(diverged)) +
           ",\"failed\":" + (failed.empty() ? "null" : jsonString(failed)) + "}";
}

std::string csvText(const std::vector<Measured>& runs, const std::string& key) {
    std::string text = key;
    for (const Measure& measure : measures()) text += std::string(",") + measure.name;
    text += ",diverged\n";
    for (const Measured& run : runs) {
        text += csvCell(valueOf(run));
        for (const double value : run.summary.values) text += "," + numberText(value);
        text += run.summary.diverged.empty() ? ",0\n" : ",1\n";
    }
    return text;
}

Chart historyChart(const std::vector<Measured>& runs, int measure, const std::string& title) {
    const Measure& m = measures()[static_cast<std::size_t>(measure)];
    const FittingUnit unit = shownUnit(m);
    Chart chart{title, "time", "s", meaningAtATime(m), unit.name, false, {}};
    for (const Measured& run : runs) {
        Series series{run.variant.label, run.summary.time,
                      run.summary.history[static_cast<std::size_t>(measure)]};
        for (double& y : series.y) y *= unit.scale;
        chart.series.push_back(std::move(series));
    }
    useFittingUnit(chart);
    return chart;
}

Chart sweepChart(const std::vector<Measured>& runs, int measure, const std::string& key) {
    const Measure& m = measures()[static_cast<std::size_t>(measure)];
    const FittingUnit unit = shownUnit(m);
    Chart chart{"", key, "", fmt::format("{}: {}", m.name, m.meaning), unit.name, false, {}};
    Series series;
    setValues(runs, chart, series);
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const double y = unit.scale * runs[i].summary.values[static_cast<std::size_t>(measure)];
        const bool whole = runs[i].summary.diverged.empty();
        series.y.push_back(whole ? y : std::numeric_limits<double>::quiet_NaN());
        if (whole && y > 0.0) least = std::min(least, y), most = std::max(most, y);
    }
    chart.logY = most > 100.0 * least;
    chart.series.push_back(std::move(series));
    useFittingUnit(chart);
    return chart;
}

}  // namespace demos
