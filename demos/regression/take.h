/// One run of a scene for a test: what was seen, and what was written down meanwhile.
#pragma once
#include <cstdint>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/regression/course.h"
#include "demos/scene/expect.h"
#include "render/image.h"

namespace demos {

struct TakenPicture {
    double time = 0.0;        // s, as [snapshot] lists it
    std::uint64_t state = 0;  // hash of the world, of the step nearest to it
    render::Image image;
};

struct Take {
    Course course;
    std::vector<ExpectationResult> expectations;
    std::vector<TakenPicture> pictures;
    std::string renderer;  // its name; empty where nothing was drawn
};

/// Plays the whole scene and draws its [snapshot] times. Throws Stop (diverged), render::Error.
Take takeOf(const FilmPlan& plan);

}  // namespace demos
