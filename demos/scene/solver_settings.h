/// The solver's settings by the names that scene files give them.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "engine/settings.h"

namespace demos {

using SettingList = std::vector<std::pair<std::string, std::string>>;

/// steady, fast or seed.
engine::Settings presetCalled(const std::string& name);

/// The settings that affect a run's results: "solver.substeps", "4".
SettingList solverSettings(const engine::Settings& settings);

/// One of them, or of those that only a figure lists: "solver.lanes". Empty if there is none.
std::string settingOf(const engine::Settings& settings, const std::string& key);

/// "substeps=8 sweeps=1": the settings that differ from the preset's; empty: none.
std::string besidePreset(const engine::Settings& settings, const std::string& preset);

}  // namespace demos
