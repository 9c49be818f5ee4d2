/// The runs of a slide.
#pragma once
#include <string>
#include <vector>

#include "demos/comparisons/comparing.h"
#include "demos/comparisons/sweeping.h"
#include "demos/film/variants.h"
#include "demos/options/options.h"
#include "demos/slides/deck.h"

namespace demos {

/// The runs of a slide, in order: @{2.drift} is a number of the second.
struct LoadedRuns {
    std::string name;  // of the scene or the comparison
    std::string key;   // the setting of a sweep, or empty
    std::vector<Variant> variants;
    bool several = false;

    bool isSweep() const { return !key.empty(); }
};

/// The corresponding options of `impulse compare` and `impulse sweep`.
CompareOptions compareOptions(const SlideRuns& runs, const Options& shared);
SweepOptions sweepOptions(const SlideRuns& runs, const Options& shared);

/// `options`: those of the slide's pictures (slide_options.h). Empty if the slide names no scene.
/// Throws Stop (usage), SceneError.
LoadedRuns loadRuns(const Slide& slide, const Options& options);

/// When the run ends on this slide, s.
double untilOf(const Slide& slide, const Variant& variant);

/// The time of the film's poster, s of the run.
double posterTime(const Slide& slide, double until);

/// The times of a still or a strip, s of the run, increasing.
std::vector<double> momentTimes(const Slide& slide, double until);

/// A text that is the same for the same physics, on any slide.
std::string runKey(const Slide& slide, const Variant& variant);

}  // namespace demos
