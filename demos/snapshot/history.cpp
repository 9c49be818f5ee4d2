#include "demos/snapshot/history.h"

#include <algorithm>
#include <cmath>

#include "demos/play/motion_camera.h"
#include "demos/snapshot/camera.h"
#include "demos/snapshot/colors.h"

namespace demos {
namespace {

constexpr double kHalfLife = 0.5;        // s, of a peak
constexpr std::size_t kMostGhosts = 12;  // more cannot be distinguished
constexpr double kLeastImpulse = 1e-6;   // N s; less is rounding
constexpr double kLeastNudge = 1e-9;     // m

void decay(double& peak, double dt, double least) {
    peak *= std::exp2(-dt / kHalfLife);
    if (peak < least) peak = 0.0;
}

void rememberPeaks(const Stage& stage, History& history) {
    decay(history.impulsePeak, stage.dt(), kLeastImpulse);
    decay(history.nudgePeak, stage.dt(), kLeastNudge);
    for (const engine::ContactState& contact : stage.world.contacts())
        history.impulsePeak =
            std::max({history.impulsePeak, contact.impulse, contact.friction.norm()});
    for (const Vec3& nudge : history.nudges)
        history.nudgePeak = std::max(history.nudgePeak, nudge.norm());
}

void rememberGhost(const Stage& stage, double every, History& history) {
    const long long steps = std::max(std::llround(every * stage.scene.hz), 1LL);
    if (stage.world.report().step % steps != 0) return;
    std::vector<engine::Pose> poses;
    for (const engine::BodyId id : stage.bodies) poses.push_back(stage.world.pose(id));
    if (history.ghosts.size() == kMostGhosts) history.ghosts.erase(history.ghosts.begin());
    history.ghosts.push_back(std::move(poses));
}

/// The position p of a body or of all that move, smoothed with the time constant T:
/// f' = (p - f) / T, exact for p at rest.
void rememberFollowed(const Stage& stage, History& history) {
    const CameraDescription& camera = stage.scene.camera;
    const bool all = camera.move == CameraMove::follow, lags = camera.followLag > 0.0;
    if (!all && (camera.follow.empty() || !lags)) return;
    const std::optional<Vec3> place = all ? middleOf(stage) : placeOf(stage, camera.follow);
    if (!place) return;
    if (!history.followed) history.followed = history.followedFirst = place;
    const double share = lags ? -std::expm1(-stage.dt() / camera.followLag) : 1.0;
    *history.followed += share * (*place - *history.followed);
}

}  // namespace

void remember(const Stage& stage, const Overlays& overlays, History& history) {
    rememberPeaks(stage, history);
    rememberFollowed(stage, history);
    if (overlays.ghost) rememberGhost(stage, overlays.ghostEvery, history);
    if (overlays.stats) {
        const engine::Energy energy = stage.world.energy();
        history.lowestPotential = std::min(history.lowestPotential, energy.potential);
        history.largestEnergy = std::max(history.largestEnergy, energy.total());
    }
    for (const double value : colorValues(stage, overlays.colorBy))
        history.largestValue = std::max(history.largestValue, value);
}

}  // namespace demos
