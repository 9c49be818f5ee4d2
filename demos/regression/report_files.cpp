#include "demos/regression/report_files.h"

#include "demos/load/load_scene.h"
#include "demos/regression/baseline.h"
#include "demos/regression/junit.h"
#include "demos/regression/report_page.h"
#include "demos/regression/verdict_json.h"
#include "demos/scene/reader.h"
#include "render/encode/file.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

/// An unreadable baseline has already been reported; the page then has no trajectory of it.
Trajectory trajectoryIn(const fs::path& folder) try {
    std::optional<Baseline> baseline = readBaseline(folder);
    return baseline ? std::move(baseline->trajectory) : Trajectory{};
} catch (const BaselineError&) {
    return {};
}

ReportTrajectories coursesOf(const SceneVerdict& verdict, const TestOptions& options,
                             const fs::path& results) try {
    ReportTrajectories trajectories;
    trajectories.actual = trajectoryIn(results / (verdict.name + kSnapshotsEnding));
    if (trajectories.actual.moments.empty()) return trajectories;  // nothing differed
    trajectories.baseline = trajectoryIn(verdict.folder);
    trajectories.camera = loadScene(verdict.scene, options.overrides).camera;
    return trajectories;
} catch (const SceneError&) {  // parts of a test may be merged where its scenes are not
    return {};
}

}  // namespace

void writeReport(const TestVerdict& verdict, const TestOptions& options, const fs::path& results) {
    std::vector<ReportTrajectories> trajectories;
    for (const SceneVerdict& scene : verdict.scenes)
        trajectories.push_back(coursesOf(scene, options, results));
    render::writeFileAtomically(results / "report.json", jsonOf(verdict));
    render::writeFileAtomically(results / "junit.xml", junitXml(verdict));
    render::writeFileAtomically(results / "report.html",
                                reportPage(verdict, trajectories, results));
}

}  // namespace demos
