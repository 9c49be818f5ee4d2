#include "demos/regression/judge.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/film/outputs.h"
#include "demos/regression/divergence.h"
#include "demos/regression/run_settings.h"
#include "demos/regression/scene_inputs.h"
#include "demos/text/complaints.h"
#include "demos/text/text_hash.h"
#include "demos/text/version.h"
#include "render/driver_environment.h"
#include "render/encode/file.h"
#include "render/encode/png.h"
#include "render/encode/png_read.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

/// Why the run cannot be compared with the baseline; empty if it can.
std::string obstacle(const Baseline& baseline, const Actual& actual) {
    const Baseline& now = actual.baseline;
    if (baseline.trajectory.hz != now.trajectory.hz)
        return fmt::format(
            "the baseline was made with {} steps a second, the scene has {}; accept "
            "it with impulse test --update changed",
            baseline.trajectory.hz, now.trajectory.hz);
    if (baseline.width != now.width || baseline.height != now.height)
        return fmt::format(
            "the baseline's pictures are {}x{}, those of the scene {}x{}; accept it "
            "with impulse test --update changed",
            baseline.width, baseline.height, now.width, now.height);
    return {};
}

void breakAll(const std::string& problem, SceneVerdict& verdict) {
    verdict.problem = problem;
    for (PictureVerdict& picture : verdict.pictures) picture.kind = PictureVerdict::Kind::broken;
}

void judgePictures(const TestRun& played, const Actual& actual, const Baseline& baseline,
                   const fs::path& folder, SceneVerdict& verdict) {
    for (std::size_t i = 0; i < verdict.pictures.size(); ++i) {
        PictureVerdict& picture = verdict.pictures[i];
        const BaselinePicture* kept = pictureAt(baseline, picture.time);
        if (!kept) continue;  // a time that was added to the list
        picture.baseline = (folder / pictureFile(picture.time)).string();
        picture.baselineState = kept->state;
        try {
            judgePicture(played.pictures[i].image, actual.png[i], readPicture(folder, *kept),
                         verdict.snapshot.gate, picture);
        } catch (const BaselineError& error) {
            picture.kind = PictureVerdict::Kind::broken;
            picture.problem = error.what();
        }
    }
}

/// The first of the incidents and how many more there are.
std::string incidentLine(const char* head, const std::vector<std::string>& texts) {
    return fmt::format("{}: {}{}", head, texts.front(),
                       texts.size() > 1 ? fmt::format(" (and {} more)", texts.size() - 1) : "");
}

/// An incident that is not in the baseline fails the test, even if no pose tells; its step may
/// differ, as far as the poses stay within the tolerances. `baseline`: null if there is none yet.
void judgeIncidents(const std::vector<PlayedIncident>& incidents,
                    const std::vector<BaselineIncident>* baseline, PhysicsVerdict& physics) {
    std::vector<std::string> added, known;
    for (const PlayedIncident& incident : incidents) {
        const auto isSame = [&](const BaselineIncident& kept) {
            return kept.body == incident.body && kept.trouble == troubleWord(incident.trouble);
        };
        const bool kept = baseline && std::any_of(baseline->begin(), baseline->end(), isSame);
        (kept ? known : added).push_back(incident.line);
    }
    if (!known.empty())
        physics.lines.push_back(incidentLine("an incident, as in the baseline", known));
    if (added.empty()) return;
    physics.lines.insert(physics.lines.begin(), incidentLine("a new incident", added));
    if (baseline) physics.kind = PhysicsVerdict::Kind::changed;
}

SceneVerdict::State stateOf(const SceneVerdict& verdict) {
    const bool seen = std::all_of(verdict.pictures.begin(), verdict.pictures.end(),
                                  [](const PictureVerdict& picture) { return picture.passes(); });
    return verdict.keepsContract() && seen && verdict.physics.passes() && verdict.problem.empty()
               ? SceneVerdict::State::passed
               : SceneVerdict::State::failed;
}

}  // namespace

Actual actualOf(const TestRun& played, const FilmPlan& plan, const ChosenScene& chosen,
                const std::vector<std::string>& overrides) {
    Actual actual;
    Baseline& baseline = actual.baseline;
    baseline.scene = plan.name;
    baseline.home = homeSeenFrom(chosen.folder, chosen.scene);
    baseline.version = kVersion;
    baseline.renderer = played.renderer;
    baseline.pixels = render::pixelClass(plan.picture.reproducible);
    baseline.width = plan.picture.width;
    baseline.height = plan.picture.height;
    baseline.settings = settingsOf(plan, played.renderer);
    baseline.inputs = inputsOf(plan.scene(), chosen.scene, overrides);
    baseline.trajectory = played.trajectory;
    for (const PlayedIncident& incident : played.incidents)
        baseline.incidents.push_back({incident.step, incident.body, troubleWord(incident.trouble)});
    for (const TestPicture& picture : played.pictures) {
        const auto& png = actual.png.emplace_back(render::encodePng(picture.image));
        baseline.pictures.push_back({picture.time, picture.state, hashOf(png)});
    }
    return actual;
}

bool letsPass(const PictureGate& gate, const render::Difference& difference) {
    return render::samePicture(difference, {gate.levels, gate.windowPixels, gate.ssim, ""});
}

void judgePicture(const render::Image& actual, const std::vector<std::uint8_t>& png,
                  const std::vector<std::uint8_t>& baseline, const PictureGate& gate,
                  PictureVerdict& verdict) try {
    verdict.difference.sameSize = true;
    verdict.kind = PictureVerdict::Kind::same;
    if (png == baseline) return;
    verdict.difference = render::compare(render::decodePng(baseline, actual.width, actual.height),
                                         actual, gate.levels);
    if (verdict.difference.differing == 0) return;
    verdict.kind = letsPass(gate, verdict.difference) ? PictureVerdict::Kind::within
                                                      : PictureVerdict::Kind::changed;
} catch (const render::Error& error) {
    throw BaselineError(printable(verdict.baseline) + ": " + error.what());
}

void judge(const TestRun& played, const Actual& actual, const fs::path& folder,
           SceneVerdict& verdict) {
    verdict.expectations = played.expectations;
    for (const BaselinePicture& picture : actual.baseline.pictures)
        verdict.pictures.push_back(
            {picture.time, PictureVerdict::Kind::added, 0, picture.state, {}, {}, {}, {}});
    std::vector<double> times;
    for (const BaselinePicture& picture : actual.baseline.pictures) times.push_back(picture.time);
    verdict.orphans = orphansOf(folder, times);
    try {
        const std::optional<Baseline> baseline = readBaseline(folder);
        if (!baseline) {
            verdict.state = SceneVerdict::State::added;
            judgeIncidents(played.incidents, nullptr, verdict.physics);
            return;
        }
        verdict.settings = changesBetween(*baseline, actual.baseline);
        const std::string problem = obstacle(*baseline, actual);
        if (!problem.empty()) breakAll(problem, verdict);
        if (problem.empty()) {
            verdict.physics = diverge(baseline->trajectory, actual.baseline.trajectory,
                                      verdict.snapshot.tolerance);
            judgeIncidents(played.incidents, &baseline->incidents, verdict.physics);
            judgePictures(played, actual, *baseline, folder, verdict);
        }
    } catch (const BaselineError& error) {
        breakAll(error.what(), verdict);
    }
    verdict.state = stateOf(verdict);
}

void writeBaseline(const Actual& actual, const Tolerance& tolerance, const fs::path& folder) {
    render::makeFolder(folder);
    for (std::size_t i = 0; i < actual.png.size(); ++i)
        render::writeFileAtomically(folder / pictureFile(actual.baseline.pictures[i].time),
                                    actual.png[i]);
    render::writeFileAtomically(folder / kBaselineFile, jsonOf(actual.baseline, tolerance));
}

}  // namespace demos
