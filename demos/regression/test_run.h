/// One run of a scene for a test: what was seen, and what was written down meanwhile.
#pragma once
#include <cstdint>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/play/expect.h"
#include "demos/regression/trajectory.h"
#include "render/image.h"

namespace demos {

struct TestPicture {
    double time = 0.0;        // s, as [snapshot] lists it
    std::uint64_t state = 0;  // hash of the world, of the step nearest to it
    render::Image image;
};

struct TestRun {
    Trajectory trajectory;
    std::vector<ExpectationResult> expectations;
    std::vector<TestPicture> pictures;
    std::string renderer;  // its name; empty where nothing was drawn
};

/// Plays the whole scene and draws its [snapshot] times. Throws Stop (diverged), render::Error.
TestRun runForTest(const FilmPlan& plan);

}  // namespace demos
