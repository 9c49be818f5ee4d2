/// A run of a scene, played to its end and recorded.
#pragma once
#include "demos/export/recording.h"
#include "tests/demos/reading.h"

namespace demos::test {

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
