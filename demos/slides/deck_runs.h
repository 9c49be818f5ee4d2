/// The runs behind a deck's numbers, charts and tables. Each is simulated once, physics only,
/// however many slides need it.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "demos/measures/measures.h"
#include "demos/measures/summary.h"
#include "demos/play/expect.h"
#include "demos/slides/run_moment.h"

namespace demos {

/// A run up to a moment.
struct PlayedMoment {
    Summary summary;
    Recorder recorder;
    RunMoment moment;    // if a step failed before: the last good state
    std::string failed;  // then why; else empty
};

class DeckRuns {
public:
    /// Requests a moment. All requests must come before the first result is taken. `key`: the same
    /// for the same physics; `until`: s.
    void askMoment(const std::string& key, const SceneDescription& scene, double until);
    /// Requests expectations: the run is then simulated to its end.
    void askExpectations(const std::string& key, const SceneDescription& scene);

    /// The results of requests; the first one taken of a run simulates it. Throws Stop
    /// (interrupted).
    const PlayedMoment& moment(const std::string& key, double until);
    const std::vector<ExpectationResult>& expectations(const std::string& key);
    /// Empty, or why a step failed before the last requested moment.
    const std::string& failed(const std::string& key);
    /// What happened until the last requested moment (Player::incident), or why a step failed.
    const std::string& incident(const std::string& key);

    int played() const { return played_; }  // runs

private:
    struct Run {
        SceneDescription scene;
        std::map<long, std::optional<PlayedMoment>> moments;  // by step
        bool toEnd = false, played = false;
        std::string failed, incident;
        std::vector<ExpectationResult> expectations;

        long lastStep() const;
        long stepAt(double until) const;
    };
    Run& run(const std::string& key, const SceneDescription& scene);
    Run& playedRun(const std::string& key);
    static void play(Run& run);

    std::map<std::string, Run> runs_;
    int played_ = 0;
};

}  // namespace demos
