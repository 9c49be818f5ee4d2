/// The measures of several runs: as a table of text, as JSON lines, as CSV and as charts.
#pragma once
#include <string>
#include <vector>

#include "demos/charts/chart.h"
#include "demos/film/variants.h"
#include "demos/measures/summary.h"

namespace demos {

struct Measured {
    Variant variant;
    Summary summary;
};

/// Numbers as text with four digits; their units are in the head.
struct MeasureCells {
    std::vector<int> measures;  // in measures(): those that are not 0 in all runs
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;  // one row per run
};
MeasureCells cellsOf(const std::vector<Measured>& runs);

/// A line per run; measures that are 0 in all runs are left out.
std::string tableText(const std::vector<Measured>& runs);

/// "LABEL: LINE" of the first run that diverged or had an incident, and how many others did; "" if
/// none did.
std::string incidentLine(const std::vector<Measured>& runs);

/// The same of the first run in which an expectation of the scene failed.
std::string failedRunsLine(const std::vector<Measured>& runs);

/// A JSON object on one line: label, settings, measures, how it diverged or null.
std::string jsonLine(const Measured& run);

/// A row per run: the swept values, then every measure.
std::string csvText(const std::vector<Measured>& runs, const std::string& key);

/// The measure over time, a line per run.
Chart historyChart(const std::vector<Measured>& runs, int measure, const std::string& title);

/// The measure over the swept value: numbers (on a log axis if each is a multiple of the last) or
/// names.
Chart sweepChart(const std::vector<Measured>& runs, int measure, const std::string& key);

}  // namespace demos
