/// The verdict's pictures in the report: in the page as long as they fit, linked where they do not.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "demos/regression/verdict.h"

namespace demos {

/// Adds to `page`, the verdict's JSON: "images", each {src, linked}, and in every picture the
/// places of its two among them, "baseline_image" and "actual_image"; -1: not there.
/// `bytes`: what may be added to the page's text.
void addImages(nlohmann::ordered_json& page, const TestVerdict& verdict,
               const std::filesystem::path& folder, long bytes);

}  // namespace demos
