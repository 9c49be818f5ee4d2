/// The verdict as one HTML file to review it with: no network, no other file.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "demos/regression/trajectory.h"
#include "demos/regression/verdict.h"
#include "demos/scene/description.h"

namespace demos {

/// The two runs of a scene and from where its film is seen. A trajectory without moments is not
/// there.
struct ReportTrajectories {
    Trajectory baseline, actual;
    CameraDescription camera;
};

/// `trajectories`: by place in `verdict.scenes`; fewer are allowed. `folder`: where the page will
/// be. The verdict's pictures are put into the page, those that differ first, as long as it stays
/// below `bytes`; the others are linked relative to `folder`, and the page says so. A picture that
/// cannot be read is shown as missing.
std::string reportPage(const TestVerdict& verdict,
                       const std::vector<ReportTrajectories>& trajectories,
                       const std::filesystem::path& folder, long bytes = 9'500'000);

}  // namespace demos
