/// Simulates a stage step by step, and keeps what pictures need from the steps in between.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "demos/snapshot/snapshot.h"

namespace demos {

/// A body that could not continue as it was, or an energy jump.
struct PlayedIncident {
    engine::Trouble trouble = engine::Trouble::none;
    std::string body;    // its name; empty: no single body is concerned
    long long step = 0;
    std::string line;    // "scene: step 31 (t = 0.517 s): body 'ball': ..."
};

class Player {
public:
    Player(const SceneDescription& scene, const Overlays& overlays);
    Player(const Player&) = delete;  // the world's observer points to this object
    Player& operator=(const Player&) = delete;

    /// One step. After an incident the simulation continues without the body, or with a slower one.
    /// Throws Stop (diverged) with a line like an incident's if the step failed.
    void step();
    void step(int count);
    /// What has happened until now, each trouble of a body once.
    const std::vector<PlayedIncident>& incidents() const { return incidents_; }
    /// The line of the first of them, and how many more there are; "" if there are none.
    std::string incident() const;
    /// Throws Stop (diverged) with incident(), if there is one.
    void stopIfIncident() const;
    render::Frame frame(double time) const { return frame(time, history_); }
    /// With another history, of which the scales of arrows and colours are taken.
    render::Frame frame(double time, const History& history) const {
        return snapshot(stage_, overlays_, time, history);
    }
    const Stage& stage() const { return stage_; }
    const History& history() const { return history_; }
    /// Replaces the observer of the nudges' overlay (engine::World::observe).
    void observe(std::function<void(engine::Phase, int)> observer) {
        stage_.world.observe(std::move(observer));
    }
    /// From now on the stage's world reports touch events (engine::World::touches).
    void watchTouches() { stage_.world.watchTouches(true); }

    /// All that the next steps, and pictures of them, depend on (engine::World::saveState).
    void saveState(std::vector<std::uint8_t>& bytes, std::size_t at = 0) const;
    /// Goes on from there: in a player of the same scene, with overlays that need no other memory.
    /// False: these bytes are not such a state; then this object may only be destroyed.
    bool restoreState(std::span<const std::uint8_t> bytes);

private:
    template <class Bytes>
    void keep(Bytes& bytes);
    void watchNudges();
    void remember();
    void look(const engine::Incident& incident);

    Stage stage_;
    Overlays overlays_;
    History history_;
    std::vector<PlayedIncident> incidents_;
    std::vector<Vec3> before_;  // m, positions of the bodies before the nudges
};

/// The line for an incident of the last step.
std::string incidentText(const Stage& stage, const engine::Incident& incident);

/// "too fast", for files.
const char* troubleWord(engine::Trouble trouble);

/// "'ball', step 31", for a picture.
std::string bodyAndStep(const PlayedIncident& incident);

/// "diverged: WHAT" in the corner of a picture; the renderer breaks and cuts it to fit.
render::Text incidentMark(const std::string& what);

}  // namespace demos
