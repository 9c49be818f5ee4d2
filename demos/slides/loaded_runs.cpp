#include "demos/slides/loaded_runs.h"

#include <charconv>
#include <utility>

#include "demos/film/film_plan.h"
#include "demos/text/complaints.h"

namespace demos {

CompareOptions compareOptions(const SlideRuns& runs, const Options& shared) {
    CompareOptions options;
    static_cast<Options&>(options) = shared;
    options.vary = runs.vary;
    options.cases = runs.cases;
    return options;
}

SweepOptions sweepOptions(const SlideRuns& runs, const Options& shared) {
    SweepOptions options;
    static_cast<Options&>(options) = shared;
    options.over = runs.over;
    return options;
}

LoadedRuns loadRuns(const Slide& slide, const Options& options) {
    LoadedRuns loaded;
    if (!slide.runs.any()) return loaded;
    loaded.several = slide.runs.several();
    if (!slide.runs.over.empty()) {
        Sweeping sweeping = sweepingOf(sweepOptions(slide.runs, options));
        loaded.key = sweeping.key;
        loaded.variants = std::move(sweeping.variants);
        loaded.name = loaded.variants.front().scene.name;
    } else if (loaded.several) {
        Comparing comparing = comparingOf(compareOptions(slide.runs, options));
        loaded.name = comparing.name;
        loaded.variants = std::move(comparing.variants);
    } else {
        Variant alone{"", {}, sceneOf(options)};
        alone.label = loaded.name = alone.scene.name;
        loaded.variants.push_back(std::move(alone));
    }
    return loaded;
}

double untilOf(const Slide& slide, const Variant& variant) {
    return slide.until.value_or(variant.scene.seconds);
}

double posterTime(const Slide& slide, double until) {
    if (slide.poster == "first") return slide.from;
    if (slide.poster == "last") return until;
    double time = until;
    std::from_chars(slide.poster.data(), slide.poster.data() + slide.poster.size(), time);
    return time;
}

std::vector<double> momentTimes(const Slide& slide, double until) {
    if (slide.exhibit == Exhibit::still) return {slide.at.value_or(posterTime(slide, until))};
    if (slide.moments < 2) return {until};
    std::vector<double> times;
    for (int i = 0; i < slide.moments; ++i)
        times.push_back(slide.from + (until - slide.from) * i / (slide.moments - 1));
    return times;
}

std::string runKey(const Slide& slide, const Variant& variant) {
    std::string key = slide.runs.comparison.empty() ? slide.runs.scene : variant.scene.name;
    for (const auto* settings : {&slide.runs.settings, &variant.settings})
        for (const std::string& setting : *settings) key += "\n" + setting;
    return key + "\n" + numberText(variant.scene.seconds);
}

}  // namespace demos
