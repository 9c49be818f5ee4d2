/// A run of a scene, played to its end and recorded.
#pragma once
#include "demos/export/recording.h"
#include "tests/demos/reading.h"

namespace demos::test {

/// A bob on a rod of 1 m, level at first.
const std::string kPendulum =
    "[[body]]\nname = 'bob'\nshape = { sphere = 0.1 }\nat = [1, 2, 0]\n"
    "[[joint]]\nname = 'hook'\ntype = 'distance'\na = 'world'\nb = 'bob'\n"
    "anchor_a = [0, 2, 0]\nanchor_b = [0, 0, 0]\n";

struct Recorded {
    Player player;
    Recording run;

    explicit Recorded(const SceneDescription& scene, long steps = 60, int stepsPerFrame = 1,
                      const Overlays& overlays = {})
        : player(scene, overlays) {
        player.watchTouches();
        FilmPlan plan;
        plan.panels.push_back({scene, overlays, ""});
        plan.name = scene.name;
        plan.stepsPerFrame = stepsPerFrame;
        plan.fps = scene.hz / stepsPerFrame;
        plan.frames = static_cast<int>(steps / stepsPerFrame);
        RunRecorder recorder(plan);
        recorder.look(player, 0);
        for (long step = 1; step <= steps; ++step) {
            player.step();
            recorder.look(player, step);
        }
        run = recorder.finished(player.stage());
    }
    explicit Recorded(const std::string& text, long steps = 60, int stepsPerFrame = 1,
                      const Overlays& overlays = {})
        : Recorded(read(text), steps, stepsPerFrame, overlays) {}
};

}  // namespace demos::test
