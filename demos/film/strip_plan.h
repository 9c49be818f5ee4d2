/// Which moments of a film a strip shows, and how.
#pragma once
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/film/film_strip.h"

namespace demos {

struct StripOptions : Options {
    int moments = 6;
    std::vector<double> times;  // s; empty = evenly over the film
    int columns = 0;            // 0 = up to six, all rows alike
};

/// Pictures of half the quality's size; the scene's own text would stand in every one of them, six
/// times the same. Throws as planFilm does.
FilmPlan planStrip(StripOptions options);

/// After how many steps each picture is taken; rising. Throws Stop (usage).
std::vector<int> stripSteps(const FilmPlan& plan, const StripOptions& options);

/// Empty paper of the plan's theme.
render::Image stripPaper(const StripLayout& layout, const FilmPlan& plan);

/// The picture in its place, its time (s) below it.
void placeMoment(const StripLayout& layout, int moment, const render::Image& picture, double time,
                 const FilmPlan& plan, render::Image& paper);

}  // namespace demos
