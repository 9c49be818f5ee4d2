/// The files that a test writes in addition to the pictures: report.html, report.json, junit.xml.
#pragma once
#include <filesystem>

#include "demos/regression/test_options.h"
#include "demos/regression/verdict.h"

namespace demos {

/// Reads the trajectories of scenes that differ, from their baselines and from the test's results.
/// `options`: the scenes were read with these. Throws render::Error.
void writeReport(const TestVerdict& verdict, const TestOptions& options,
                 const std::filesystem::path& results);

}  // namespace demos
