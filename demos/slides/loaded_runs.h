/// Who plays on a slide.
#pragma once
#include <string>
#include <vector>

#include "demos/comparisons/comparing.h"
#include "demos/comparisons/sweeping.h"
#include "demos/film/variants.h"
#include "demos/options/options.h"
#include "demos/slides/deck.h"

namespace demos {

/// The runs of a slide, in their order: @{2.drift} is of the second.
struct LoadedRuns {
    std::string name;  // of the scene or the comparison
    std::string key;   // the setting that runs through its values, or empty
    std::vector<Variant> variants;
    bool several = false;

    bool isSweep() const { return !key.empty(); }
};

/// What `impulse compare` and `impulse sweep` would be asked for.
CompareOptions compareOptions(const SlideRuns& runs, const Options& shared);
SweepOptions sweepOptions(const SlideRuns& runs, const Options& shared);

/// `options`: with what the slide's pictures are drawn (slide_options.h). Nobody where the slide
/// names no scene. Throws Stop (usage), SceneError.
LoadedRuns loadRuns(const Slide& slide, const Options& options);

/// s: until when the run goes on this slide.
double untilOf(const Slide& slide, const Variant& variant);

/// s of the run: where the film rests, and what stands for it on paper.
double posterTime(const Slide& slide, double until);

/// s of the run, rising: of a still or a strip.
std::vector<double> momentTimes(const Slide& slide, double until);

/// The same text for the same physics, whichever slide it is on.
std::string runKey(const Slide& slide, const Variant& variant);

}  // namespace demos
