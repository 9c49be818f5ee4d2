#include "demos/slides/deck_runs.h"

#include <algorithm>
#include <cmath>

#include "demos/processes/signals.h"
#include "demos/snapshot/player.h"
#include "demos/text/stop.h"
#include "engine/base/check.h"

namespace demos {
namespace {

/// Simulates a run with everything that records it.
struct Watch {
    Player player;
    SummaryRecorder summary;
    Recorder recorder;
    ExpectationChecker checker;

    explicit Watch(const SceneDescription& scene)
        : player(scene, Overlays{.trails = false}),
          summary(player.stage()),
          checker(player.stage()) {
        look();
    }
    void look() {
        recorder.look(player.stage());
        checker.look(player.stage());
    }
    /// False if the step failed; `why` then says why.
    bool step(std::string& why) try {
        summary.step(player);
        look();
        return true;
    } catch (const Stop& stop) {
        if (stop.code() != Exit::diverged) throw;
        why = stop.what();
        return false;
    }
    PlayedMoment now(const std::string& failed) const {
        return {summary.summary(failed.empty() ? player.incident() : failed), recorder,
                momentOf(player.stage()), failed};
    }
};

}  // namespace

long DeckRuns::Run::stepAt(double until) const { return std::lround(until * scene.hz); }

long DeckRuns::Run::lastStep() const {
    const long end = toEnd ? std::max(stepAt(scene.seconds), 1L) : 0L;
    return moments.empty() ? end : std::max(end, moments.rbegin()->first);
}

DeckRuns::Run& DeckRuns::run(const std::string& key, const SceneDescription& scene) {
    const auto [place, added] = runs_.try_emplace(key);
    if (added) place->second.scene = scene;
    ENGINE_CHECK(!place->second.played, "ask for all moments before taking one");
    return place->second;
}

void DeckRuns::askMoment(const std::string& key, const SceneDescription& scene, double until) {
    Run& asked = run(key, scene);
    asked.moments[asked.stepAt(until)];
}

void DeckRuns::askExpectations(const std::string& key, const SceneDescription& scene) {
    run(key, scene).toEnd = true;
}

void DeckRuns::play(Run& run) {
    Watch watch(run.scene);
    const long last = run.lastStep();
    for (long step = 0; step <= last; ++step) {
        if (step > 0 && !watch.step(run.failed)) break;
        if (const auto asked = run.moments.find(step); asked != run.moments.end())
            asked->second = watch.now({});
        if (interrupted()) throw Stop(Exit::interrupted, "interrupted");
    }
    for (auto& [step, moment] : run.moments)
        if (!moment) moment = watch.now(run.failed);
    run.incident = run.failed.empty() ? watch.player.incident() : run.failed;
    run.expectations = watch.checker.results();
    run.played = true;
}

DeckRuns::Run& DeckRuns::playedRun(const std::string& key) {
    const auto found = runs_.find(key);
    ENGINE_CHECK(found != runs_.end(), "ask for the run before taking anything of it");
    if (!found->second.played) {
        play(found->second);
        ++played_;
    }
    return found->second;
}

const PlayedMoment& DeckRuns::moment(const std::string& key, double until) {
    const Run& run = playedRun(key);
    const auto found = run.moments.find(run.stepAt(until));
    ENGINE_CHECK(found != run.moments.end(), "ask for the moment before taking it");
    return *found->second;
}

const std::vector<ExpectationResult>& DeckRuns::expectations(const std::string& key) {
    return playedRun(key).expectations;
}

const std::string& DeckRuns::failed(const std::string& key) { return playedRun(key).failed; }

const std::string& DeckRuns::incident(const std::string& key) { return playedRun(key).incident; }

}  // namespace demos
