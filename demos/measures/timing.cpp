#include "demos/measures/timing.h"

#include <algorithm>
#include <cmath>

#include "demos/measures/clock.h"
#include "demos/processes/signals.h"
#include "demos/snapshot/player.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

constexpr int kStepsASecond = 60;
constexpr int kWindow = 2 * kStepsASecond;

/// Simulates the scene, from the player's step on, in pieces of 1/60 s: play(number of steps of the
/// piece, whether it counts).
template <class Play>
void playPieces(const SceneDescription& scene, const Player& player, Play play) {
    const int pieces = std::max(static_cast<int>(std::lround(scene.seconds * kStepsASecond)), 1);
    long long done = player.stage().world.report().step;
    for (int piece = 1; piece <= pieces; ++piece) {
        const long long until = static_cast<long long>(piece) * scene.hz / kStepsASecond;
        if (until <= done && done > 0) continue;
        play(static_cast<int>(until - done), piece > pieces - kWindow);
        done = until;
        if (interrupted()) throw Stop(Exit::interrupted, "interrupted");
    }
}

/// Adds up the time from the beginning of each phase to that of the next.
struct PhaseClock {
    PhaseTimes sum{};  // s
    std::size_t phase = 0;
    double since = 0.0;
    bool counts = false;

    void enter(std::size_t next) {
        const double now = seconds(CLOCK_MONOTONIC);
        if (counts) sum[phase] += now - since;
        phase = next;
        since = now;
    }
};

}  // namespace

double Timing::median() const { return medianOf(ms); }

double Timing::nanosecondsAPoint() const {
    double sum = 0.0;
    for (const double one : ms) sum += one;
    return points > 0.0 ? 1e6 * sum / points : 0.0;
}

Timing timeScene(const SceneDescription& scene, const std::function<void(Player&)>& begin) {
    Player player(scene, Overlays{.trails = false});
    if (begin) begin(player);
    Timing timing;
    playPieces(scene, player, [&](int steps, bool counts) {
        const double before = processorTime();
        player.step(steps);
        const double after = processorTime();
        if (!counts) return;
        timing.ms.push_back(1e3 * (after - before));
        timing.points += player.stage().world.errors().contacts;
    });
    timing.scene = scene.name;
    timing.bodies = scene.bodies.size();
    timing.joints = scene.joints.size();
    timing.contacts = player.stage().world.errors().contacts;
    timing.steps = static_cast<int>(timing.ms.size());
    timing.hash = player.stage().world.hash();
    timing.incident = player.incident();
    return timing;
}

PhaseTimes timePhases(const SceneDescription& scene, const std::function<void(Player&)>& begin) {
    Player player(scene, Overlays{.trails = false});
    if (begin) begin(player);
    PhaseClock clock;
    int counted = 0;
    player.observe(
        [&clock](engine::Phase phase, int) { clock.enter(1 + static_cast<std::size_t>(phase)); });
    playPieces(scene, player, [&](int steps, bool counts) {
        clock.counts = counts;
        counted += counts;
        for (int i = 0; i < steps; ++i) {
            clock.since = seconds(CLOCK_MONOTONIC);
            clock.phase = 0;
            player.step();
            clock.enter(0);
        }
    });
    for (double& sum : clock.sum) sum *= 1e3 / std::max(counted, 1);
    return clock.sum;
}

}  // namespace demos
