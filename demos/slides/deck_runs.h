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
    RunMoment moment;  // if the run diverged before: its last good state
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
    /// Empty, or a line that says how the run diverged before its last requested moment.
    const std::string& diverged(const std::string& key);

    int played() const { return played_; }  // runs

private:
    struct Run {
        SceneDescription scene;
        std::map<long, std::optional<PlayedMoment>> moments;  // by step
        bool toEnd = false, played = false;
        std::string diverged;
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
