#include "demos/snapshot/player.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/text/stop.h"
#include "render/palette.h"

namespace demos {
namespace {

constexpr double kTrailSeconds = 3.0;  // older points are dropped

const char* what(engine::Trouble trouble) {
    switch (trouble) {
        case engine::Trouble::none:
            return "nothing is wrong";
        case engine::Trouble::positionNotFinite:
            return "position is not finite; the body was removed";
        case engine::Trouble::velocityNotFinite:
            return "velocity is not finite; the body was removed";
        case engine::Trouble::positionTooLarge:
            return "farther than 100 km from the origin; the body was removed";
        case engine::Trouble::velocityTooLarge:
            return "faster than 10000 m/s or rad/s; the body was slowed down";
        case engine::Trouble::tooManyRows:
            return "more than 1000 rows, the limit of the direct solver; use solver.type = "
                   "\"impulses\"";
        case engine::Trouble::tooManyContacts:
            return "more than 200000 contacts, or millions of pairs of bodies, parts or triangles near each "
                   "other, as of a body deep in a fine mesh; move them apart";
        case engine::Trouble::energyJump:
            return "energy grew tenfold in one step without a cause";
    }
    return "unknown trouble";
}

}  // namespace

std::string incidentText(const Stage& stage, const engine::Incident& incident) {
    const engine::StepReport& report = stage.world.report();
    const bool known = incident.body.index >= 0;
    return fmt::format("{}: step {} (t = {:.3f} s): {}{}", stage.scene.name, report.step, report.time,
                       known ? fmt::format("body '{}': ", stage.nameOf(incident.body)) : "",
                       what(incident.trouble));
}

const char* troubleWord(engine::Trouble trouble) {
    switch (trouble) {
        case engine::Trouble::none:
            return "none";
        case engine::Trouble::positionNotFinite:
            return "position not finite";
        case engine::Trouble::velocityNotFinite:
            return "velocity not finite";
        case engine::Trouble::positionTooLarge:
            return "too far";
        case engine::Trouble::velocityTooLarge:
            return "too fast";
        case engine::Trouble::tooManyRows:
            return "too many rows";
        case engine::Trouble::tooManyContacts:
            return "too many contacts";
        case engine::Trouble::energyJump:
            break;
    }
    return "energy jump";
}

std::string bodyAndStep(const PlayedIncident& incident) {
    return fmt::format("{}, step {}",
                       incident.body.empty() ? "energy" : fmt::format("'{}'", incident.body),
                       incident.step);
}

render::Text incidentMark(const std::string& what) {
    return {"diverged: " + what, render::Corner::topLeft, 22.0f, render::fromHex(0xc0392b)};
}

Player::Player(const SceneDescription& scene, const Overlays& overlays)
    : stage_(scene), overlays_(overlays) {
    if (overlays_.nudges) watchNudges();
    remember();
}

/// A nudge moves a body between the phases 'nudges' and the one that follows.
void Player::watchNudges() {
    before_.resize(stage_.bodies.size());
    history_.nudges.assign(stage_.bodies.size(), Vec3::Zero());
    stage_.world.observe([this, nudging = false](engine::Phase phase, int) mutable {
        for (std::size_t i = 0; i < stage_.bodies.size(); ++i) {
            const Vec3& at = stage_.world.pose(stage_.bodies[i]).position;
            if (nudging) history_.nudges[i] += at - before_[i];
            before_[i] = at;
        }
        nudging = phase == engine::Phase::nudges;
    });
}

void Player::step() {
    std::fill(history_.nudges.begin(), history_.nudges.end(), Vec3::Zero());
    if (!stage_.step())
        throw Stop(Exit::diverged, incidentText(stage_, {stage_.world.report().trouble, {}}));
    for (const engine::Incident& incident : stage_.world.report().incidents) look(incident);
    remember();
}

void Player::look(const engine::Incident& incident) {
    const std::string body = incident.body.index >= 0 ? stage_.nameOf(incident.body) : "";
    const auto isSame = [&](const PlayedIncident& known) {
        return known.body == body && known.trouble == incident.trouble;
    };
    if (std::ranges::any_of(incidents_, isSame)) return;  // a body may be too fast in every step
    incidents_.push_back({incident.trouble, body, stage_.world.report().step,
                          incidentText(stage_, incident)});
}

std::string Player::incident() const {
    if (incidents_.size() < 2) return incidents_.empty() ? "" : incidents_.front().line;
    return fmt::format("{} (and {} more)", incidents_.front().line, incidents_.size() - 1);
}

void Player::stopIfIncident() const {
    if (!incidents_.empty()) throw Stop(Exit::diverged, incident());
}

void Player::step(int count) {
    for (int i = 0; i < count; ++i) step();
}

void Player::remember() {
    demos::remember(stage_, overlays_, history_);
    const std::size_t most = static_cast<std::size_t>(kTrailSeconds * stage_.scene.hz) + 1;
    for (std::size_t i = 0; i < stage_.trails.size(); ++i) {
        std::vector<Vec3>& trail = stage_.trails[i];
        if (trail.size() >= most) trail.erase(trail.begin());
        for (std::size_t body = 0; body < stage_.bodies.size(); ++body)
            if (stage_.scene.bodies[body].name == stage_.scene.look.trails[i])
                trail.push_back(stage_.world.pose(stage_.bodies[body]).position);
    }
}

}  // namespace demos
