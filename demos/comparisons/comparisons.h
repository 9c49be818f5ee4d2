/// The built-in comparisons, by name: impulse compare clamping
#pragma once
#include <string>
#include <vector>

namespace demos {

struct Comparison {
    struct Case {
        const char* label;
        std::vector<std::string> settings;  // as --set takes them
    };
    const char* name;
    const char* point;  // what one should see
    const char* scene;
    double seconds;    // of the film
    const char* plot;  // a measure (measures/summary.h)
    std::vector<Case> cases;
};

const std::vector<Comparison>& builtinComparisons();
/// Null if there is none of this name.
const Comparison* comparisonCalled(const std::string& name);

}  // namespace demos
