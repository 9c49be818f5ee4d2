/// What a test leaves beside the pictures: report.html, report.json, junit.xml.
#pragma once
#include <filesystem>

#include "demos/regression/test_options.h"
#include "demos/regression/verdict.h"

namespace demos {

/// Reads the trajectories of the scenes that differ from their baselines and from what was shown.
/// `options`: what the scenes were read with. Throws render::Error.
void writeReport(const TestVerdict& verdict, const TestOptions& options,
                 const std::filesystem::path& results);

}  // namespace demos
