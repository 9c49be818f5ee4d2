/// All panels of a film, played on one clock and drawn into one picture.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/snapshot/player.h"

namespace demos {

/// A panel of its own with the plan's plot below it, and the cursor at `time` (s); the panel itself
/// where the plan has no plot.
render::Image withStrip(render::Image panel, const FilmPlan& plan, double time);

class Composite {
public:
    /// `plan` has to stay.
    explicit Composite(const FilmPlan& plan);

    /// One frame further. A single panel that diverges throws Stop; among others it stays as it was
    /// last, and says so. `drawn`: draw() will follow.
    void advance(bool drawn);
    render::Image draw(int frame, render::Renderer& renderer);
    /// What the data passes show: the first panel without overlays.
    render::Frame plainFrame(int frame) const;
    /// The first panel with others than its own.
    render::Frame frameWith(const Overlays& overlays, int frame) const;
    const Stage& stage() const { return shows_.front()->player.stage(); }
    /// `watcher` sees the first panel's stage after every step from now on.
    void watchSteps(std::function<void(const Stage&)> watcher) { watcher_ = std::move(watcher); }
    /// Of the first panel: its world tells who begins to touch from now on.
    void watchTouches() { shows_.front()->player.watchTouches(); }
    /// Of all panels' states.
    std::uint64_t hash() const;

private:
    struct Show {
        Player player;
        int steps;            // a frame
        std::string trouble;  // empty: it plays
        std::vector<render::Frame> seen;  // since the shutter opened, a step each
    };
    void advance(Show& show, bool drawn, double time);
    render::Frame frameOf(const Show& show, double time) const;
    render::Image drawPanel(Show& show, double time, render::Renderer& renderer) const;

    const FilmPlan& plan_;
    int frame_ = 0;
    std::vector<std::unique_ptr<Show>> shows_;
    std::function<void(const Stage&)> watcher_;
};

}  // namespace demos
