/// The runs that a deck's numbers, charts and tables are of: each is played once, physics only,
/// however many slides ask for it.
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

/// A run, up to a moment.
struct PlayedMoment {
    Summary summary;
    Recorder recorder;
    RunMoment moment;  // of a run that diverged before: its last good state
};

class DeckRuns {
public:
    /// All has to be asked for before anything is taken. `key`: the same for the same physics;
    /// `until`: s.
    void askMoment(const std::string& key, const SceneDescription& scene, double until);
    /// The run is played to its end then.
    void askExpectations(const std::string& key, const SceneDescription& scene);

    /// Of what was asked for; the first who takes anything of a run plays it. Throws Stop
    /// (interrupted).
    const PlayedMoment& moment(const std::string& key, double until);
    const std::vector<ExpectationResult>& expectations(const std::string& key);
    /// Empty, or the line that says how the run diverged before its last moment that was asked for.
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
