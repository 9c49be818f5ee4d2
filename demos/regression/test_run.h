/// One run of a scene for a test: its pictures, trajectory and expectations.
#pragma once
#include <cstdint>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/play/expect.h"
#include "demos/regression/trajectory.h"
#include "demos/snapshot/player.h"
#include "render/image.h"

namespace demos {

struct TestPicture {
    double time = 0.0;        // s, as [snapshot] lists it
    std::uint64_t state = 0;  // hash of the world at the step nearest to `time`
    render::Image image;
};

struct TestRun {
    Trajectory trajectory;
    std::vector<ExpectationResult> expectations;
    std::vector<TestPicture> pictures;
    std::vector<PlayedIncident> incidents;
    std::string renderer;  // its name; empty where nothing was drawn
};

/// Simulates the whole scene and draws it at its [snapshot] times. Throws Stop (diverged) if a step
/// fails, render::Error.
TestRun runForTest(const FilmPlan& plan);

}  // namespace demos
