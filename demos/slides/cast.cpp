#include "demos/slides/cast.h"

#include <charconv>
#include <utility>

#include "demos/film/film_plan.h"
#include "demos/report/comparing.h"
#include "demos/report/sweeping.h"
#include "demos/scene/complaints.h"

namespace demos {

Cast castOf(const Slide& slide, const Options& options) {
    Cast cast;
    if (!slide.runs.any()) return cast;
    cast.several = slide.runs.several();
    if (!slide.runs.over.empty()) {
        Sweeping sweeping = sweepingOf(options);
        cast.key = sweeping.key;
        cast.variants = std::move(sweeping.variants);
        cast.name = cast.variants.front().scene.name;
    } else if (cast.several) {
        Comparing comparing = comparingOf(options);
        cast.name = comparing.name;
        cast.variants = std::move(comparing.variants);
    } else {
        Variant alone{"", {}, sceneOf(options)};
        alone.label = cast.name = alone.scene.name;
        cast.variants.push_back(std::move(alone));
    }
    return cast;
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
