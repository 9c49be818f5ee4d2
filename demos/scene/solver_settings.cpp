#include "demos/scene/solver_settings.h"

#include "demos/scene/solver_words.h"
#include "demos/text/complaints.h"

namespace demos {
namespace {

std::string truth(bool value) { return value ? "true" : "false"; }

/// Also those that only a figure lists.
SettingList allSettings(const engine::Settings& s) {
    SettingList all = solverSettings(s);
    all.emplace_back("solver.max_substeps", std::to_string(s.maxSubsteps));
    all.emplace_back("solver.lanes", truth(s.lanes));
    all.emplace_back("solver.depenetration_speed", numberText(s.depenetrationSpeed));
    all.emplace_back("solver.sleep_after", numberText(s.sleepAfter));
    return all;
}

}  // namespace

engine::Settings presetCalled(const std::string& name) {
    return name == "seed"   ? engine::Settings::seed()
           : name == "fast" ? engine::Settings::fast()
                            : engine::Settings::steady();
}

SettingList solverSettings(const engine::Settings& s) {
    SettingList out;
    const auto add = [&out](const char* key, const std::string& value) {
        out.emplace_back(std::string("solver.") + key, value);
    };
    add("type", wordOf(s.method));
    add("substeps", std::to_string(s.substeps));
    add("sweeps", std::to_string(s.sweeps));
    add("min_sweeps", std::to_string(s.minSweeps));
    add("tolerance", numberText(s.tolerance));
    add("nudges", std::to_string(s.nudges));
    add("nudge_factor", numberText(s.nudgeFactor));
    add("slop", numberText(s.slop));
    add("baumgarte", numberText(s.baumgarte));
    add("order", wordOf(s.order));
    add("block", truth(s.block));
    add("joints", wordOf(s.joints));
    add("warm_start", truth(s.warmStart));
    add("accumulate", truth(s.accumulate));
    add("sleeping", truth(s.sleeping));
    return out;
}

std::string settingOf(const engine::Settings& settings, const std::string& key) {
    for (const auto& [name, value] : allSettings(settings))
        if (name == key) return value;
    return {};
}

std::string besidePreset(const engine::Settings& settings, const std::string& preset) {
    const SettingList own = allSettings(settings), usual = allSettings(presetCalled(preset));
    std::string text;
    for (std::size_t i = 0; i < own.size(); ++i)
        if (own[i].second != usual[i].second)
            text += (text.empty() ? "" : " ") + own[i].first.substr(sizeof "solver." - 1) + "=" +
                    own[i].second;
    return text;
}

}  // namespace demos
