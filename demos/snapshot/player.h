/// A stage that is played step by step, with what pictures of it need from the steps in between.
#pragma once
#include <functional>
#include <string>
#include <utility>

#include "demos/snapshot/snapshot.h"

namespace demos {

class Player {
public:
    Player(const SceneDescription& scene, const Overlays& overlays);
    Player(const Player&) = delete;  // the world's observer points here
    Player& operator=(const Player&) = delete;

    /// One step. Throws Stop (diverged) with `scene: step 1234 (t = 5.142 s): body 'box7': ...`.
    void step();
    void step(int count);
    render::Frame frame(double time) const { return snapshot(stage_, overlays_, time, history_); }
    const Stage& stage() const { return stage_; }
    const History& history() const { return history_; }
    /// In place of what the nudges' overlay watches (engine::World::observe).
    void observe(std::function<void(engine::Phase, int)> observer) {
        stage_.world.observe(std::move(observer));
    }
    /// The stage's world tells who begins to touch from now on (engine::World::touches).
    void watchTouches() { stage_.world.watchTouches(true); }

private:
    void watchNudges();
    void remember();

    Stage stage_;
    Overlays overlays_;
    History history_;
    std::vector<Vec3> before_;  // m, where the bodies were when the nudges began
};

/// The line for a step that did not end well.
std::string troubleText(const Stage& stage);

}  // namespace demos
