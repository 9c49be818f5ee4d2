#include "demos/regression/scene_test.h"

#include <fmt/format.h>

#include <cstdlib>

#include "demos/film/film_needs.h"
#include "demos/film/film_plan.h"
#include "demos/regression/accept.h"
#include "demos/regression/judge.h"
#include "demos/scene/reader.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/json_limits.h"
#include "demos/text/stop.h"
#include "demos/text/text_hash.h"

namespace demos {
namespace {

namespace fs = std::filesystem;
using State = SceneVerdict::State;

std::uint64_t fingerprintOf(const ChosenScene& chosen, const FilmPlan& plan, const TestSetup& run) {
    TestOptions own = run.options;
    own.scenes = {chosen.scene};
    TextHash hash;
    hash.add(std::to_string(demos::fingerprintOf(plan, own)));
    hash.add(run.renderer);
    hash.add(contentOf(chosen.folder / kBaselineFile, kBaselineJson.bytes));
    for (const double time : plan.scene().snapshot.times)
        hash.add(contentOf(chosen.folder / pictureFile(time), kMostPictureBytes));
    for (const std::string& name : orphansOf(chosen.folder, plan.scene().snapshot.times))
        hash.add(name);
    return hash.value();
}

void fail(SceneVerdict& verdict, const std::string& problem) {
    verdict.state = State::failed;
    verdict.problem = problem;
}

/// A scene with a failed expectation writes no baseline.
void update(const fs::path& shown, Update update, SceneVerdict& verdict) {
    const bool missing = verdict.state == State::added;
    if (!verdict.keepsContract()) {
        verdict.state = State::failed;
        return;
    }
    if (missing && update == Update::none)
        return fail(verdict, "there is no baseline, and --update is none; make one with impulse "
                             "test --update missing, look at it and commit it");
    if (missing) return acceptAll(shown, verdict.folder);
    const bool all = update == Update::all && !verdict.isAsItWas();
    const bool differs = verdict.state == State::failed || !verdict.changedScene().empty();
    if (all || (update == Update::changed && differs)) {
        acceptAll(shown, verdict.folder);
        verdict.state = State::updated;
        return;
    }
    if (update != Update::missing || verdict.state != State::failed) return;
    if (!verdict.onlyAddsPictures()) return;
    for (const PictureVerdict& picture : verdict.pictures)
        if (picture.kind == PictureVerdict::Kind::added)
            acceptPicture(shown, verdict.folder, picture.time);
    verdict.state = State::updated;
}

void play(const ChosenScene& chosen, const FilmPlan& plan, const TestSetup& run,
          SceneVerdict& verdict) {
    const TestRun played = runForTest(plan);
    if (played.pictures.empty()) {  // only expectations
        verdict.expectations = played.expectations;
        verdict.state = verdict.keepsContract() ? State::passed : State::failed;
        if (fs::exists(chosen.folder / kBaselineFile))
            fail(verdict, fmt::format("there is a baseline in '{}', but the scene lists no [snapshot] times; list "
                                      "them again, or remove the folder",
                                      printable(chosen.folder.string())));
        if (!played.incidents.empty())
            throw Stop(Exit::diverged,
                       played.incidents.front().line +
                           "; only the baseline of a scene with [snapshot] times can record it");
        return;
    }
    const Actual actual = actualOf(played, plan, chosen, run.options.overrides);
    judge(played, actual, chosen.folder, verdict);
    const fs::path shown = run.results / (chosen.name + kSnapshotsEnding);
    if (verdict.state == State::passed && verdict.isAsItWas()) return;
    writeBaseline(actual, verdict.snapshot.tolerance, shown);
    for (PictureVerdict& picture : verdict.pictures)
        picture.actual = (shown / pictureFile(picture.time)).string();
    update(shown, run.update, verdict);
}

}  // namespace

FilmPlan planOfTest(const ChosenScene& chosen, const TestOptions& options) {
    TestOptions own = options;
    own.scenes = {chosen.scene};
    own.quiet = true;
    own.anyStep = true;
    own.plotBelow = false;  // a snapshot shows a single moment
    if (!own.size) {
        const Snapshot& snapshot = sceneOf(own).snapshot;
        own.size = PictureSize{snapshot.width, snapshot.height};
    }
    FilmPlan plan = planPictures(own);
    for (Panel& panel : plan.panels) panel.scene.look.dither = false;  // its pixels are compared
    plan.picture.threads = 0;
    checkNeeds(needsOf(plan, 1, {}), plan);
    return plan;
}

/// As other tools read it: set, and neither empty nor "false" nor "0".
bool inCi() {
    const char* value = std::getenv("CI");
    const std::string ci = value ? value : "";
    return !ci.empty() && ci != "false" && ci != "0";
}

Update updateOf(const TestOptions& options) {
    if (options.update.empty()) return inCi() ? Update::none : Update::missing;
    if (options.update == "none") return Update::none;
    if (options.update == "missing") return Update::missing;
    return options.update == "changed" ? Update::changed : Update::all;
}

void removeShown(const fs::path& folder) {
    std::error_code ignored;
    std::vector<fs::path> own;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        if (name == kBaselineFile || (name.starts_with('t') && name.ends_with(".png")))
            own.push_back(entry.path());
    }
    for (const fs::path& file : own) fs::remove(file, ignored);
    fs::remove(folder, ignored);  // when it is empty
}

SceneTested testScene(const ChosenScene& chosen, const TestSetup& run) noexcept {
    SceneTested tested;
    SceneVerdict& verdict = tested.verdict;
    try {
        verdict.name = chosen.name;
        verdict.scene = chosen.scene;
        verdict.folder = chosen.folder.string();
        removeShown(run.results / (chosen.name + kSnapshotsEnding));
        const FilmPlan plan = planOfTest(chosen, run.options);
        verdict.title = plan.scene().title;
        verdict.snapshot = plan.scene().snapshot;
        verdict.snapshot.width = plan.picture.width;
        verdict.snapshot.height = plan.picture.height;
        tested.fingerprint = fingerprintOf(chosen, plan, run);
        verdict.cached = run.cache && run.cache->has(chosen.name, tested.fingerprint);
        if (!verdict.cached) play(chosen, plan, run, verdict);
    } catch (const SceneError& error) {
        verdict.state = State::error;
        verdict.problem = error.lines().front();
    } catch (const std::exception& error) {
        verdict.state = State::error;
        verdict.problem = error.what();
    }
    return tested;
}

}  // namespace demos
