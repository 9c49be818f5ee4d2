/// All panels of a film, simulated on one clock and drawn into one picture.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/play/run_watch.h"
#include "demos/snapshot/player.h"

namespace demos {

/// A single panel with the plan's plot below it and the plot's cursor at `time` (s). Without a plot
/// returns `panel` unchanged.
render::Image withStrip(render::Image panel, const FilmPlan& plan, double time);

/// The plan's last state before `frame` (what is drawn of it included); nothing if none fits, or if
/// the film needs all steps.
std::optional<ReadState> stateBefore(int frame, const FilmPlan& plan);

/// Whether a film can continue from a state: not with several panels, nor with data passes of contacts and events,
/// which need all steps.
bool needsOneState(const FilmPlan& plan);

class Composite {
public:
    /// `plan` must outlive this object.
    explicit Composite(const FilmPlan& plan);

    /// Goes on from stateBefore(frame), as if it had advanced there. Returns the frame; 0: there is
    /// none.
    int startBefore(int frame);
    /// The single panel at the current frame.
    void saveState(std::vector<std::uint8_t>& bytes) const { shows_.front()->player.saveState(bytes); }
    /// The same as a file of this folder. `memory`: of the one before. Throws render::Error.
    void writeState(const std::filesystem::path& folder, std::vector<std::uint8_t>& memory) const;
    /// Goes to `frame`, of which another process has saved these bytes.
    void restoreState(int frame, std::span<const std::uint8_t> bytes);
    /// Advances by one frame. A single panel whose step fails throws Stop; one of several shows its
    /// last good state and says so. `drawn`: draw() will follow.
    void advance(bool drawn);
    render::Image draw(int frame, render::Renderer& renderer);
    /// What the data passes show: the first panel without overlays.
    render::Frame plainFrame(int frame) const;
    /// The first panel with these overlays instead of its own.
    render::Frame frameWith(const Overlays& overlays, int frame) const;
    const Stage& stage() const { return shows_.front()->player.stage(); }
    /// `watcher` sees the first panel's stage after every step from now on.
    void watchSteps(std::function<void(const Stage&)> watcher) { watcher_ = std::move(watcher); }
    /// The first panel's world reports touch events from now on.
    void watchTouches() { shows_.front()->player.watchTouches(); }
    /// What happened until now (Player::incident) in the first panel that has an incident; of
    /// several panels, with its title. "": nothing.
    std::string incident() const;
    /// The same, after what is left of the scene, which no frame shows. Call it last.
    std::string incidentAtEnd();
    /// From now on, which should be time 0, a single panel's run is watched for notesAtEnd().
    void watchRun();
    /// What else to know of the run (RunWatch), after incidentAtEnd(): a line each.
    std::string notesAtEnd() const;
    /// A hash of all panels' states.
    std::uint64_t hash() const;

private:
    struct Show {
        Player player;
        int steps;            // per frame
        std::string trouble;  // empty: none
        std::vector<render::Frame> seen;  // since the shutter opened, one per step
    };
    void advance(Show& show, bool drawn, double time);
    void stepOnce(Show& show);
    render::Frame frameOf(const Show& show, double time) const;
    render::Frame pictureOf(const Show& show, double time) const;
    render::Image drawPanel(Show& show, double time, render::Renderer& renderer) const;

    const FilmPlan& plan_;
    int frame_ = 0;
    std::vector<std::unique_ptr<Show>> shows_;
    std::function<void(const Stage&)> watcher_;
    std::optional<RunWatch> run_;
};

}  // namespace demos
