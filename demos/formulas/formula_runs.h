/// A formula as a line of ordinary text: letters, raised and lowered ones, fractions with a slash.
#pragma once
#include <string>
#include <vector>

namespace demos {

struct FormulaRun {
    std::string text;
    bool italic = false, bold = false;
    int level = 0;  // 1: raised, -1: lowered
};

/// `mathMl`: as mathMlOf() returns it. Neighbours of the same look are one run.
std::vector<FormulaRun> formulaRuns(const std::string& mathMl);

}  // namespace demos
