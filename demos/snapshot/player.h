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

    /// One step. Throws Stop (diverged) with `scene: step 1234 (t = 5.142 s): body 'box7': ...` where
    /// there was none, or a body could not go on as it was.
    void step();
    void step(int count);
    /// From now on the rest goes on without such bodies: their lines are in incidents(), each once.
    void goOn() { goesOn_ = true; }
    const std::vector<std::string>& incidents() const { return incidents_; }
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
    void look(const engine::Incident& incident);

    Stage stage_;
    Overlays overlays_;
    History history_;
    bool goesOn_ = false;
    std::vector<engine::Incident> known_;
    std::vector<std::string> incidents_;
    std::vector<Vec3> before_;  // m, where the bodies were when the nudges began
};

/// The line for what went wrong in the last step.
std::string incidentText(const Stage& stage, const engine::Incident& incident);

}  // namespace demos
