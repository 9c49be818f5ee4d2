#include "demos/regression/report_files.h"

#include "demos/regression/baseline.h"
#include "demos/regression/junit.h"
#include "demos/regression/report_page.h"
#include "demos/regression/verdict_json.h"
#include "demos/scene/reader.h"
#include "render/encode/file.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

/// A baseline that cannot be read was told already; the page does without its course.
Course courseIn(const fs::path& folder) try {
    std::optional<Baseline> baseline = readBaseline(folder);
    return baseline ? std::move(baseline->course) : Course{};
} catch (const BaselineError&) {
    return {};
}

ReportCourses coursesOf(const SceneVerdict& verdict, const Options& options,
                        const fs::path& results) {
    ReportCourses courses;
    courses.actual = courseIn(results / (verdict.name + kSnapshotsEnding));
    if (courses.actual.moments.empty()) return courses;  // as it was: nothing was left
    courses.baseline = courseIn(verdict.folder);
    courses.camera = loadScene(verdict.scene, options.overrides).camera;
    return courses;
}

}  // namespace

void writeReport(const TestVerdict& verdict, const Options& options, const fs::path& results) {
    std::vector<ReportCourses> courses;
    for (const SceneVerdict& scene : verdict.scenes)
        courses.push_back(coursesOf(scene, options, results));
    render::writeFileAtomically(results / "report.json", jsonOf(verdict));
    render::writeFileAtomically(results / "junit.xml", junitXml(verdict));
    render::writeFileAtomically(results / "report.html", reportPage(verdict, courses, results));
}

}  // namespace demos
