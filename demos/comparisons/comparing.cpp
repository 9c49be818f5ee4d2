#include "demos/comparisons/comparing.h"

#include <fmt/format.h>

#include "demos/comparisons/comparisons.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

Comparing comparingOf(const Comparison& comparison, const CompareOptions& options) {
    Comparing plan{options, comparison.name, comparison.point, comparison.plot, {}};
    plan.options.scenes = {comparison.scene};
    if (!options.seconds) plan.options.seconds = comparison.seconds;
    std::vector<std::vector<std::string>> settings;
    std::vector<std::string> labels;
    for (const Comparison::Case& one : comparison.cases) {
        settings.push_back(one.settings);
        labels.emplace_back(one.label);
    }
    plan.variants = variantsOf(plan.options, settings, labels, "--vary");
    return plan;
}

/// "label: key=value key=value"; the label may be left out.
std::pair<std::string, std::vector<std::string>> caseFrom(const std::string& text) {
    const std::size_t colon = text.find(": ");
    std::vector<std::string> settings(1);
    for (const char c : colon == std::string::npos ? text : text.substr(colon + 2)) {
        if (c != ' ')
            settings.back() += c;
        else if (!settings.back().empty())
            settings.emplace_back();
    }
    if (settings.back().empty()) settings.pop_back();
    for (const std::string& setting : settings)
        if (setting.find('=') == std::string::npos)
            throw Stop(Exit::usage,
                       fmt::format("--case '{}': must be 'LABEL: KEY=VALUE KEY=VALUE', for example "
                                   "'fine: solver.substeps=8 solver.sweeps=2'",
                                   printable(text)));
    return {colon == std::string::npos ? "" : text.substr(0, colon), settings};
}

}  // namespace

Comparing comparingOf(const CompareOptions& options) {
    if (const Comparison* comparison = comparisonCalled(options.scene())) {
        if (!options.vary.empty() || !options.cases.empty())
            throw Stop(Exit::usage, fmt::format("'{}' is a built-in comparison; for --vary and "
                                                "--case name a scene",
                                                comparison->name));
        return comparingOf(*comparison, options);
    }
    Comparing plan{options, "", "", "", {}};
    if (!options.vary.empty() && !options.cases.empty())
        throw Stop(Exit::usage, "--vary and --case cannot be given together; use one of them");
    std::vector<Variation> variations;
    for (const std::string& text : options.vary)
        variations.push_back(variationFrom(text, "--vary"));
    std::vector<std::vector<std::string>> settings;
    std::vector<std::string> labels;
    if (!variations.empty()) settings = combinations(variations);
    for (const std::string& text : options.cases) {
        auto [label, own] = caseFrom(text);
        labels.push_back(label);
        settings.push_back(own);
    }
    if (settings.size() < 2 || settings.size() > kMostCompared)
        throw Stop(Exit::usage,
                   fmt::format("{} to compare; give two to four, for example --vary "
                               "solver.sweeps=1,4,16; built-in ones: impulse compare --list",
                               settings.size()));
    plan.variants =
        variantsOf(options, settings, labels, options.vary.empty() ? "--case" : "--vary");
    plan.name = plan.variants.front().scene.name;
    return plan;
}

}  // namespace demos
