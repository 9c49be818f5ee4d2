#include "demos/slides/slide_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "demos/comparisons/sweeping.h"
#include "demos/film/strip_plan.h"
#include "demos/film/variant_panels.h"
#include "demos/look/type.h"
#include "demos/slides/slide_arrangement.h"
#include "demos/slides/slide_options.h"
#include "render/overlay.h"

namespace demos {
namespace {

constexpr int kMostShown = 240;  // frames a second of a film

/// px of a slide: narrower panels have no room for time, bodies and solver.
constexpr double kNarrowPanel = 400.0;

/// The rate at which all runs have steps: the greatest common divisor of their hz.
int commonHz(const LoadedRuns& loaded) {
    int hz = loaded.variants.front().scene.hz;
    for (const Variant& variant : loaded.variants) hz = std::gcd(hz, variant.scene.hz);
    return hz;
}

bool asksFor(const Slide& slide, const char* overlay) {
    return std::find(slide.show.begin(), slide.show.end(), overlay) != slide.show.end();
}

double aspectOf(PictureSize size) { return static_cast<double>(size.width) / size.height; }

PictureSize sizeOf(const FilmPlan& film) { return {film.layout.width, film.layout.height}; }

int evenPixels(int pixels) { return std::max(pixels / 2 * 2, 2); }

/// Panels of the deck's shape with the last row centred; a single row is as wide as the slide.
void arrangePanels(const Slide& slide, PictureSize whole, FilmPlan& plan) {
    const std::size_t count = plan.panels.size();
    const PictureGrid grid = arrangement(slide, count, aspectOf(whole));
    const PictureSize room = grid.rows == 1 ? whole : pictureSize(slide, whole);
    const int width = evenPixels(room.width / grid.columns);
    const int height = evenPixels(width * whole.height / whole.width);
    const int hole = emptyCells(count, grid) * width / 2;
    plan.layout = {grid.columns * width, grid.rows * height, {}, {}};
    for (int i = 0; i < static_cast<int>(count); ++i) {
        const int row = i / grid.columns;
        const int left = row + 1 == grid.rows ? hole : 0;
        plan.layout.panels.push_back(
            {left + i % grid.columns * width, row * height, width, height});
    }
    plan.picture.width = width;
    plan.picture.height = height;
}

/// Two panels stay side by side and as high as the film, as in `impulse compare`.
void setPanels(const Slide& slide, PictureSize whole, FilmPlan& plan) {
    if (plan.panels.size() > 2) arrangePanels(slide, whole, plan);
    const PictureSize size = sizeOf(plan);
    const double pixels = pointPixels(slide, size);
    const double panel = kLeastLetters / kLabelPoints / pixels * plan.picture.width;
    for (Panel& each : plan.panels) {
        each.overlays.pixelsPerPoint = pixels;
        each.overlays.clock = panel >= kNarrowPanel;
    }
}

double withHeight(double fovDegrees, double factor) {
    const double half = std::atan(factor * std::tan(fovDegrees * std::numbers::pi / 360.0));
    return std::min(half * 360.0 / std::numbers::pi, 170.0);
}

/// Cameras are made for the deck's shape: a higher picture shows more above and below, not less at
/// the sides.
void keepSides(const Deck& deck, FilmPlan& plan) {
    const double factor = aspectOf(deck.size) / aspectOf(sizeOf(plan));
    if (factor <= 1.0) return;
    CameraDescription& camera = plan.panels.front().scene.camera;
    camera.fovDegrees = withHeight(camera.fovDegrees, factor);
    for (CameraKey& key : camera.keys) key.fovDegrees = withHeight(key.fovDegrees, factor);
}

/// One run next to words, which replace the scene's captions; without words it is drawn as usual.
void setPicture(const Slide& slide, FilmPlan& plan) {
    if (standsAlone(slide) && !slide.opening) return;
    Overlays& overlays = plan.panels.front().overlays;
    overlays.headings = asksFor(slide, "caption");
    overlays.pixelsPerPoint = pointPixels(slide, sizeOf(plan));
}

/// One run: the slide's words replace the scene's captions. Several: each has its label.
FilmPlan planClip(const Slide& slide, const Deck& deck, const LoadedRuns& loaded, Options options,
                  int fps) {
    options.fps = fps;
    std::vector<Panel> panels;
    if (loaded.several)
        panels = panelsOf(loaded.isSweep() ? spread(loaded.variants) : loaded.variants);
    else
        panels.push_back({loaded.variants.front().scene, {}, {}});
    FilmPlan plan = planFilm(std::move(panels), false, options);
    fitCameras(plan);
    if (loaded.several) {
        setPanels(slide, deck.size, plan);
        return plan;
    }
    keepSides(deck, plan);
    setPicture(slide, plan);
    plan.panels.front().overlays.headings = asksFor(slide, "caption");
    return plan;
}

SlidePlan filmOf(const Slide& slide, const Deck& deck, const LoadedRuns& loaded,
                 const Options& options, bool moving) {
    SlidePlan plan;
    plan.rate = clipRate(commonHz(loaded), deck.fps, slide.slow);
    plan.film = planClip(slide, deck, loaded, options, plan.rate.drawn);
    const double until = untilOf(slide, loaded.variants.front());
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

/// Pictures of one run are planned as in `impulse still` and `impulse strip`.
FilmPlan planMoments(const Slide& slide, const Deck& deck, const LoadedRuns& loaded,
                     Options options, const std::vector<double>& times) {
    if (loaded.several) return planClip(slide, deck, loaded, options, commonHz(loaded));
    if (slide.exhibit == Exhibit::still) {
        options.anyStep = true;
        FilmPlan plan = planPictures(options);
        keepSides(deck, plan);
        setPicture(slide, plan);
        return plan;
    }
    StripOptions strip;
    static_cast<Options&>(strip) = options;
    strip.times = times;
    FilmPlan plan = planStrip(strip);
    stripSteps(plan, strip);  // throws if two moments are the same step
    return plan;
}

/// Sets rows, columns and letters of a strip's moments.
void arrangeStrip(const Slide& slide, const Deck& deck, SlidePlan& plan) {
    const std::size_t moments = plan.frames.size();
    plan.columns = arrangement(slide, moments, aspectOf(deck.size)).columns;
    const int rows = gridOf(moments, plan.columns).rows;
    const PictureSize moment = sizeOf(plan.film);
    const double pixels = pointPixels(slide, {plan.columns * moment.width, rows * moment.height});
    plan.letters = letterPixels(kLabelPoints, pixels);
    if (!standsAlone(slide)) plan.film.panels.front().overlays.pixelsPerPoint = pixels;
}

/// Plans one frame per step, so that every time has a frame.
SlidePlan momentsOf(const Slide& slide, const Deck& deck, const LoadedRuns& loaded,
                    Options options) {
    const std::vector<double> times = momentTimes(slide, untilOf(slide, loaded.variants.front()));
    if (slide.exhibit == Exhibit::strip) {
        const PictureSize whole = *options.size;
        options.size =
            PictureSize{std::max(whole.width / 4 * 2, 2), std::max(whole.height / 4 * 2, 2)};
    }
    SlidePlan plan;
    plan.film = planMoments(slide, deck, loaded, options, times);
    plan.film.fps = commonHz(loaded);
    plan.film.stepsPerFrame = 1;
    for (const double time : times)
        plan.frames.push_back(static_cast<int>(std::lround(time * plan.film.fps)));
    plan.frames.erase(std::unique(plan.frames.begin(), plan.frames.end()), plan.frames.end());
    plan.film.frames = plan.frames.back() + 1;
    if (slide.exhibit == Exhibit::strip) arrangeStrip(slide, deck, plan);
    return plan;
}

}  // namespace

double SlidePlan::aspect() const {
    const double shape = aspectOf(sizeOf(film));
    return columns > 0 ? shape * columns / gridOf(frames.size(), columns).rows : shape;
}

ClipRate clipRate(int hz, int fps, double slow) {
    ClipRate rate{1, 1};
    const double most = fps / slow * (1.0 + 1e-9);  // 30 / 0.3 is not quite 100
    for (int drawn = 1; drawn <= hz && drawn <= most; ++drawn)
        if (hz % drawn == 0) rate.drawn = drawn;
    rate.shown = static_cast<int>(std::clamp(std::lround(rate.drawn * slow), 1L, long{kMostShown}));
    return rate;
}

std::optional<SlidePlan> planSlide(const Slide& slide, const Deck& deck, const LoadedRuns& loaded,
                                   const Options& options, bool moving) {
    if (loaded.variants.empty() || slide.exhibit == Exhibit::none) return std::nullopt;
    if (slide.exhibit == Exhibit::film) return filmOf(slide, deck, loaded, options, moving);
    return momentsOf(slide, deck, loaded, options);
}

}  // namespace demos
