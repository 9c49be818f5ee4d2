/// What a scene was played and drawn with, as keys and values: where two runs differ, the first
/// thing to look at.
#pragma once
#include "demos/film/film_plan.h"
#include "demos/regression/baseline.h"
#include "demos/regression/verdict.h"

namespace demos {

/// `scene`: as it was asked for; `renderer`: its name.
Settings settingsOf(const FilmPlan& plan, const std::string& scene, const std::string& renderer);

/// Those that differ, in the order of `actual`, then those that are gone.
std::vector<SettingChange> changesOf(const Settings& baseline, const Settings& actual);

}  // namespace demos
