#include "demos/slides/slide_tables.h"

namespace demos {
namespace {

using Row = std::vector<std::string>;

}  // namespace

MadeTable measuresTable(const std::vector<Measured>& runs, bool several, bool timing) {
    const MeasureCells cells = cellsOf(runs);
    MadeTable table;
    if (several) table.head.push_back("run");
    table.rows.resize(runs.size());
    for (std::size_t i = 0; several && i < runs.size(); ++i)
        table.rows[i].push_back(runs[i].variant.label +
                                (runs[i].summary.diverged.empty() ? "" : " (diverged)"));
    for (std::size_t column = 0; column < cells.measures.size(); ++column) {
        if (!timing && cells.measures[column] == measureCalled("ms")) continue;
        table.head.push_back(cells.head[column]);
        for (std::size_t i = 0; i < runs.size(); ++i)
            table.rows[i].push_back(cells.rows[i][column]);
    }
    return table;
}

MadeTable expectationsTable(const std::vector<RunExpectations>& runs) {
    const bool several = runs.size() > 1;
    MadeTable table;
    if (several) table.head.push_back("run");
    for (const char* name : {"what", "of", "asked", "came out", "ok"}) table.head.push_back(name);
    for (const RunExpectations& run : runs)
        for (const ExpectationResult& result : run.results) {
            Row row = {result.what, result.of, result.asked, cameOut(result),
                       result.passed ? "yes" : "no"};
            if (several) row.insert(row.begin(), run.label);
            table.rows.push_back(std::move(row));
        }
    return table;
}

}  // namespace demos
