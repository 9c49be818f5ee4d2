/// The verdict's pictures in the report: embedded while they fit, linked where they do not.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "demos/regression/verdict.h"

namespace demos {

/// Adds to `page`, the verdict's JSON: "images", each {src, linked}, and in every picture its two
/// indices into them, "baseline_image" and "actual_image"; -1: missing.
/// `bytes`: how much may be added to the page's text.
void addImages(nlohmann::ordered_json& page, const TestVerdict& verdict,
               const std::filesystem::path& folder, long bytes);

}  // namespace demos
