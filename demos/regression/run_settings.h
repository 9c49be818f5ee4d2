/// The settings a scene was run and drawn with, as keys and values: the first thing to look at when
/// two runs differ.
#pragma once
#include "demos/film/film_plan.h"
#include "demos/regression/baseline.h"
#include "demos/regression/verdict.h"

namespace demos {

/// With the defaults filled in. `renderer`: its name.
Settings settingsOf(const FilmPlan& plan, const std::string& renderer);

/// The settings that differ, in the order of `actual`, then those that only `baseline` has.
std::vector<SettingChange> changesOf(const Settings& baseline, const Settings& actual);

}  // namespace demos
