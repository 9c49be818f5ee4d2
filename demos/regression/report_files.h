/// What a test leaves beside the pictures: report.html, report.json, junit.xml.
#pragma once
#include <filesystem>

#include "demos/options.h"
#include "demos/regression/verdict.h"

namespace demos {

/// Reads the courses of the scenes that differ from their baselines and from what was shown.
/// `options`: what the scenes were read with. Throws render::Error.
void writeReport(const TestVerdict& verdict, const Options& options,
                 const std::filesystem::path& results);

}  // namespace demos
