/// Simulates a stage step by step, and keeps what pictures need from the steps in between.
#pragma once
#include <functional>
#include <string>
#include <utility>

#include "demos/snapshot/snapshot.h"

namespace demos {

class Player {
public:
    Player(const SceneDescription& scene, const Overlays& overlays);
    Player(const Player&) = delete;  // the world's observer points to this object
    Player& operator=(const Player&) = delete;

    /// One step. Throws Stop (diverged) with `scene: step 1234 (t = 5.142 s): body 'box7': ...` if
    /// the step failed, or if a body could not continue as it was.
    void step();
    void step(int count);
    /// From now on the simulation continues without such bodies; incidents() has a line for each.
    void goOn() { goesOn_ = true; }
    const std::vector<std::string>& incidents() const { return incidents_; }
    /// The first of them, and how many more there are; "" if there are none.
    std::string incident() const;
    /// Throws Stop (diverged) with incident(), if there is one.
    void stopIfIncident() const;
    render::Frame frame(double time) const { return snapshot(stage_, overlays_, time, history_); }
    const Stage& stage() const { return stage_; }
    const History& history() const { return history_; }
    /// Replaces the observer of the nudges' overlay (engine::World::observe).
    void observe(std::function<void(engine::Phase, int)> observer) {
        stage_.world.observe(std::move(observer));
    }
    /// From now on the stage's world reports touch events (engine::World::touches).
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
    std::vector<Vec3> before_;  // m, positions of the bodies before the nudges
};

/// The line for an incident of the last step.
std::string incidentText(const Stage& stage, const engine::Incident& incident);

}  // namespace demos
