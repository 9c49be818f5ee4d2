#include "demos/slides/slide_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "demos/film/strip_plan.h"
#include "demos/film/variant_panels.h"
#include "demos/report/sweeping.h"

namespace demos {
namespace {

constexpr int kMostShown = 240;  // frames a second of a film

/// Of a film of several runs: its labels are read from the back of a room.
constexpr double kPointsAcross = 360.0;

/// The steps a second that all of them have pictures of.
int commonHz(const Cast& cast) {
    int hz = cast.variants.front().scene.hz;
    for (const Variant& variant : cast.variants) hz = std::gcd(hz, variant.scene.hz);
    return hz;
}

bool asksFor(const Slide& slide, const char* overlay) {
    return std::find(slide.show.begin(), slide.show.end(), overlay) != slide.show.end();
}

/// One run: the slide says in words what the scene's captions say. Several: each has its label.
FilmPlan planClip(const Slide& slide, const Cast& cast, Options options, int fps) {
    options.fps = fps;
    std::vector<Panel> panels;
    if (cast.several)
        panels = panelsOf(cast.isSweep() ? spread(cast.variants) : cast.variants);
    else
        panels.push_back({cast.variants.front().scene, {}, {}});
    FilmPlan plan = planFilm(std::move(panels), false, options);
    if (!cast.several) plan.panels.front().overlays.headings = asksFor(slide, "caption");
    for (Panel& panel : plan.panels)
        if (cast.several) panel.overlays.pixelsPerPoint = plan.layout.width / kPointsAcross;
    return plan;
}

SlidePlan filmOf(const Slide& slide, const Deck& deck, const Cast& cast, const Options& options,
                 bool moving) {
    SlidePlan plan;
    plan.rate = clipRate(commonHz(cast), deck.fps, slide.slow);
    plan.film = planClip(slide, cast, options, plan.rate.drawn);
    const double until = untilOf(slide, cast.variants.front());
    const auto frameAt = [&](double time) {
        return static_cast<int>(std::lround(time * plan.rate.drawn));
    };
    plan.first = frameAt(slide.from);
    plan.last = std::max(frameAt(until), plan.first);
    plan.poster = std::clamp(frameAt(posterTime(slide, until)), plan.first, plan.last);
    plan.film.frames = plan.last + 1;
    if (!moving) {
        plan.frames = {plan.poster};
        return plan;
    }
    for (int frame = plan.first; frame <= plan.last; ++frame) plan.frames.push_back(frame);
    return plan;
}

/// Pictures of one run are planned as `impulse still` and `impulse strip` plan them.
FilmPlan planMoments(const Slide& slide, const Cast& cast, Options options,
                     const std::vector<double>& times) {
    if (cast.several) return planClip(slide, cast, options, commonHz(cast));
    options.command = Command::still;
    options.time = times.front();
    if (slide.exhibit == Exhibit::still) return planFilm(options);
    options.command = Command::strip;
    options.times = times;
    FilmPlan plan = planStrip(options);
    stripSteps(plan, options);  // whether they are apart
    return plan;
}

/// A frame a step, so that every time has one.
SlidePlan momentsOf(const Slide& slide, const Cast& cast, Options options) {
    const std::vector<double> times = momentTimes(slide, untilOf(slide, cast.variants.front()));
    if (slide.exhibit == Exhibit::strip) {
        const PictureSize whole = *options.size;
        options.size =
            PictureSize{std::max(whole.width / 4 * 2, 2), std::max(whole.height / 4 * 2, 2)};
    }
    SlidePlan plan;
    plan.film = planMoments(slide, cast, options, times);
    plan.film.fps = commonHz(cast);
    plan.film.stepsPerFrame = 1;
    for (const double time : times)
        plan.frames.push_back(static_cast<int>(std::lround(time * plan.film.fps)));
    plan.frames.erase(std::unique(plan.frames.begin(), plan.frames.end()), plan.frames.end());
    plan.film.frames = plan.frames.back() + 1;
    return plan;
}

}  // namespace

ClipRate clipRate(int hz, int fps, double slow) {
    ClipRate rate{1, 1};
    const double most = fps / slow * (1.0 + 1e-9);  // 30 / 0.3 is not quite 100
    for (int drawn = 1; drawn <= hz && drawn <= most; ++drawn)
        if (hz % drawn == 0) rate.drawn = drawn;
    rate.shown = static_cast<int>(std::clamp(std::lround(rate.drawn * slow), 1L, long{kMostShown}));
    return rate;
}

std::optional<SlidePlan> planSlide(const Slide& slide, const Deck& deck, const Cast& cast,
                                   const Options& options, bool moving) {
    if (cast.variants.empty() || slide.exhibit == Exhibit::none) return std::nullopt;
    if (slide.exhibit == Exhibit::film) return filmOf(slide, deck, cast, options, moving);
    return momentsOf(slide, cast, options);
}

}  // namespace demos
