/// What will be drawn of a slide, decided before anything is drawn.
#pragma once
#include <optional>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/slides/loaded_runs.h"

namespace demos {

/// Frames per second: of the run, and of the film as it plays.
struct ClipRate {
    int drawn = 30;
    int shown = 30;
};

/// As many pictures of the run as `fps` can show at the speed `slow` and the run's steps allow:
/// slow motion is smooth while there are steps, fast motion draws no frames that are not shown.
/// `shown` is a whole number from 1 to 240, so the speed is only approximately `slow`.
ClipRate clipRate(int hz, int fps, double slow);

struct SlidePlan {
    FilmPlan film;
    std::vector<int> frames;  // to draw, increasing; of a film all of them, or only its poster
    int first = 0, last = 0;  // frames of a film
    int poster = 0;           // frame of a film
    int columns = 0;          // of a strip's moments; 0: not a strip
    int letters = 0;          // least height, cap to descender, of a strip's times, pixels
    ClipRate rate;
    double timeOf(int frame) const { return film.timeOf(frame); }  // s of the run
    double aspect() const;  // width over height: of the film, still or strip
};

/// Nothing if the slide shows no picture of its runs. `moving`: plan all frames of the film, not
/// only its poster. Throws what planFilm throws.
std::optional<SlidePlan> planSlide(const Slide& slide, const Deck& deck, const LoadedRuns& loaded,
                                   const Options& options, bool moving);

}  // namespace demos
