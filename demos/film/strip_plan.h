/// Which moments of a film a strip shows, and how.
#pragma once
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/film/film_strip.h"

namespace demos {

struct StripOptions : Options {
    int moments = 6;
    std::vector<double> times;  // s; empty = evenly over the film
    int columns = 0;            // 0 = up to six, in even rows
};

/// Pictures of half the quality's size, without the scene's own text, which would be the same in
/// all of them. Throws as planFilm does.
FilmPlan planStrip(StripOptions options);

/// After how many steps each picture is taken, ascending. Throws Stop (usage).
std::vector<int> stripSteps(const FilmPlan& plan, const StripOptions& options);

/// Empty paper of the plan's theme.
render::Image stripPaper(const StripLayout& layout, const FilmPlan& plan);

/// Puts the picture in its place, with its time (s) below it.
void placeMoment(const StripLayout& layout, int moment, const render::Image& picture, double time,
                 const FilmPlan& plan, render::Image& paper);

}  // namespace demos
