/// What is drawn of a slide, settled before anything is.
#pragma once
#include <optional>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/slides/loaded_runs.h"

namespace demos {

/// Frames a second: of the run, and of the film as it plays.
struct ClipRate {
    int drawn = 30;
    int shown = 30;
};

/// As many pictures of the run as `fps` can show at this share of its speed and the run's steps
/// allow: slow motion is smooth as long as there are steps, a fast one draws none that would not be
/// seen. `shown` is a whole number from 1 to 240, and so the speed nearly what was asked for.
ClipRate clipRate(int hz, int fps, double slow);

struct SlidePlan {
    FilmPlan film;
    std::vector<int> frames;  // wanted, rising; of a film all of them, or its poster alone
    int first = 0, last = 0;  // frames of a film
    int poster = 0;           // frame of a film
    int columns = 0;          // of a strip's moments; 0: it is no strip
    int letters = 0;          // pixels from cap to descender of a strip's times, at least
    ClipRate rate;
    double timeOf(int frame) const { return film.timeOf(frame); }  // s of the run
    double aspect() const;  // width over height: of the film, still or strip
};

/// Nothing where the slide shows nothing of its runs. `moving`: the film's frames are wanted, not
/// its poster alone. Throws as planFilm does.
std::optional<SlidePlan> planSlide(const Slide& slide, const Deck& deck, const LoadedRuns& loaded,
                                   const Options& options, bool moving);

}  // namespace demos
