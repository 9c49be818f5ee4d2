#include "demos/slides/slide_tables.h"

#include <cstdlib>

#include "demos/slides/quantity.h"

namespace demos {
namespace {

constexpr int kDigits = 4;

using Row = std::vector<std::string>;

std::string shortQuantity(double value, const std::string& unit) {
    return quantityText(value, unit, kDigits, NumberSetting::text);
}

QuantityWriter shortWriter() {
    return {shortQuantity, [](const Vec3& point, const std::string& unit) {
                return vectorText(point, unit, kDigits, NumberSetting::text);
            }};
}

std::string askedOf(const RunExpectations& run, std::size_t i) {
    const SceneDescription& scene = *run.scene;
    return askedText(scene.expectations[i], scene.seconds, shortWriter());
}

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
            table.rows[i].push_back(shortQuantity(std::atof(cells.rows[i][column].c_str()), ""));
    }
    return table;
}

MadeTable expectationsTable(const std::vector<RunExpectations>& runs) {
    const bool several = runs.size() > 1;
    MadeTable table;
    if (several) table.head.push_back("run");
    for (const char* name : {"what", "of", "expected", "measured", "ok"})
        table.head.push_back(name);
    for (const RunExpectations& run : runs)
        for (std::size_t i = 0; i < run.results.size(); ++i) {
            const ExpectationResult& result = run.results[i];
            Row row = {result.what, result.of, askedOf(run, i),
                       shortQuantity(result.value, result.unit), result.passed ? "yes" : "no"};
            if (several) row.insert(row.begin(), run.label);
            table.rows.push_back(std::move(row));
        }
    return table;
}

}  // namespace demos
