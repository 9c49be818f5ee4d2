/// The states that `impulse sim` writes, and the one that it continues from.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "demos/commands/option_checks.h"
#include "demos/film/progress.h"
#include "demos/film/state_files.h"
#include "demos/play/motion_camera.h"

namespace CLI {
class App;
}

namespace demos {

struct StatesOptions {
    std::string states;  // a folder; empty: not written
    std::string from;    // a state to continue from; empty: from time 0
    std::optional<int>
        every;  // rows and states of every Nth step; none: every row, a state a second
};

void addStates(CLI::App& app, StatesOptions& options, Options& picture, OptionTexts& texts);

class States {
public:
    /// Makes the folder. Throws render::Error.
    States(const StatesOptions& options, const Options& picture, const SceneDescription& scene);

    /// For the player: the overlays whose memory the states keep, all that cost little, and those
    /// asked for.
    const Overlays& overlays() const { return overlays_; }

    /// If a state was named, the player continues from there. `last`: step with which the run ends.
    /// Throws Stop (usage), render::Error.
    void goOn(long last, Player& player) const;
    /// To be called before the first step and after every one.
    void look(const Player& player, long step);
    /// After the last step.
    void finish(const Player& player) const;
    void say(const Talk& talk) const;

private:
    std::filesystem::path folder_;
    std::string from_;
    long every_;
    Overlays overlays_;
    StateKind kind_;
    int count_ = 0;
    std::vector<std::uint8_t> memory_;  // of the last one
    std::optional<MotionSampler> motion_;
};

}  // namespace demos
