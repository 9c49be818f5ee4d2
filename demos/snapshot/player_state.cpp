// Player::saveState and restoreState: what is kept of a run, listed once for both directions
// (engine/base/state_bytes.h).
#include "demos/snapshot/player.h"
#include "engine/base/state_bytes.h"

namespace demos {
namespace {

template <class Bytes>
void keepPlace(Bytes& bytes, std::optional<Vec3>& place) {
    bool known = place.has_value();
    Vec3 at = place.value_or(Vec3::Zero());
    bytes(known, at);
    place = known ? std::optional(at) : std::nullopt;
}

/// Poses of the ghosts; no other list has a list in it.
template <class Bytes>
void keepGhosts(Bytes& bytes, std::vector<std::vector<engine::Pose>>& ghosts) {
    auto count = static_cast<std::uint32_t>(ghosts.size());
    bytes(count);
    bytes.require(count <= 1000);
    if (!bytes.isGood()) return;
    ghosts.resize(count);
    for (std::vector<engine::Pose>& poses : ghosts) {
        std::vector<double> numbers;
        for (const engine::Pose& p : poses)
            for (const double x : {p.position.x(), p.position.y(), p.position.z(), p.rotation.w(),
                                   p.rotation.x(), p.rotation.y(), p.rotation.z()})
                numbers.push_back(x);
        bytes(numbers);
        poses.clear();
        for (std::size_t i = 0; i + 7 <= numbers.size(); i += 7) {
            const double* x = numbers.data() + i;
            poses.push_back({{x[0], x[1], x[2]}, engine::Quat(x[3], x[4], x[5], x[6])});
        }
    }
}

template <class Bytes>
void keepIncidents(Bytes& bytes, std::vector<PlayedIncident>& incidents) {
    auto count = static_cast<std::uint32_t>(incidents.size());
    bytes(count);
    for (std::uint32_t i = 0; i < count && bytes.isGood(); ++i) {
        if constexpr (Bytes::kReads) incidents.emplace_back();
        PlayedIncident& incident = incidents[i];
        bytes.within(incident.trouble, 0, static_cast<int>(engine::Trouble::tooManyContacts));
        bytes(incident.body, incident.step, incident.line);
    }
}

}  // namespace

template <class Bytes>
void Player::keep(Bytes& bytes) {
    if constexpr (Bytes::kReads) incidents_.clear();
    const std::size_t trails = stage_.trails.size(), bodies = stage_.bodies.size();
    History& h = history_;
    bytes(stage_, h.impulsePeak, h.nudgePeak, h.nudges, h.largestValue, h.lowestPotential);
    bytes(h.largestEnergy);
    keepPlace(bytes, h.followed);
    keepPlace(bytes, h.followedFirst);
    keepGhosts(bytes, h.ghosts);
    keepIncidents(bytes, incidents_);
    if constexpr (!Bytes::kReads) return;
    bytes.require(stage_.trails.size() == trails);
    for (const std::vector<engine::Pose>& poses : h.ghosts) bytes.require(poses.size() == bodies);
    bytes.require(h.nudges.empty() || h.nudges.size() == bodies);
    if (!overlays_.nudges) h.nudges.clear();
    bytes.require(!overlays_.nudges || h.nudges.size() == bodies);
}

void Player::saveState(std::vector<std::uint8_t>& bytes, std::size_t at) const {
    engine::StateWriter writer(bytes, at);
    const_cast<Player*>(this)->keep(writer);  // a writer changes nothing
    stage_.world.saveState(bytes, writer.end());
}

bool Player::restoreState(std::span<const std::uint8_t> bytes) {
    engine::StateReader reader(bytes);
    keep(reader);
    return reader.isGood() && stage_.world.restoreState(reader.left());
}

}  // namespace demos
