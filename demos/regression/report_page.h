/// The verdict as one HTML file for review: it needs no network and no other file.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "demos/regression/trajectory.h"
#include "demos/regression/verdict.h"
#include "demos/scene/description.h"

namespace demos {

/// The two runs of a scene and its camera. A trajectory without moments is missing.
struct ReportTrajectories {
    Trajectory baseline, actual;
    CameraDescription camera;
};

/// `trajectories`: by index in `verdict.scenes`; fewer are allowed. `folder`: where the page will
/// be. Pictures are embedded in the page, those that differ first, while it stays below `bytes`;
/// the others are linked relative to `folder`, and the page says so. A picture that cannot be read
/// is shown as missing.
std::string reportPage(const TestVerdict& verdict,
                       const std::vector<ReportTrajectories>& trajectories,
                       const std::filesystem::path& folder, long bytes = 9'500'000);

}  // namespace demos
