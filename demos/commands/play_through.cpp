#include "demos/commands/play_through.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/processes/signals.h"
#include "demos/text/stop.h"

namespace demos {

long stepsOf(const SceneDescription& scene) {
    return std::max(std::lround(scene.seconds * scene.hz), 1L);
}

void playThrough(Player& player, const Options& options, const std::function<void(long)>& look,
                 const std::function<void()>& keep) {
    watchSignals();
    const long steps = stepsOf(player.stage().scene);
    try {
        const auto first = static_cast<long>(player.stage().world.report().step);
        look(first);
        for (long step = first + 1; step <= steps; ++step) {
            player.step();
            look(step);
            if (interrupted())
                throw Stop(Exit::interrupted,
                           fmt::format("interrupted after step {}; to run it again: {}", step,
                                       options.commandLine));
        }
    } catch (const Stop&) {
        keep();
        throw;
    }
}

}  // namespace demos
