#include "demos/regression/run_settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/scene/solver_settings.h"
#include "demos/text/complaints.h"
#include "demos/text/version.h"
#include "render/driver_environment.h"

namespace demos {
Settings settingsOf(const FilmPlan& plan, const std::string& renderer) {
    const SceneDescription& s = plan.scene();
    const Overlays& overlays = plan.panels.front().overlays;
    Settings out;
    out.emplace_back("impulse", kVersion);
    out.emplace_back("world.hz", std::to_string(s.hz));
    out.emplace_back("world.gravity",
                     fmt::format("{} {} {}", numberText(s.gravity.x()), numberText(s.gravity.y()),
                                 numberText(s.gravity.z())));
    out.emplace_back("world.seed", std::to_string(s.seed));
    out.emplace_back("seconds", numberText(s.seconds));
    out.emplace_back("solver.preset", s.preset);
    for (const auto& setting : solverSettings(s.settings)) out.push_back(setting);
    for (const char* key :
         {"solver.max_substeps", "solver.depenetration_speed", "solver.sleep_after"})
        out.emplace_back(key, settingOf(s.settings, key));
    out.emplace_back("snapshot.size",
                     fmt::format("{}x{}", plan.picture.width, plan.picture.height));
    out.emplace_back("samples", std::to_string(plan.picture.samples));
    out.emplace_back("look.theme", overlays.theme);
    out.emplace_back("look.show", fmt::format("{}", fmt::join(s.look.show, " ")));
    out.emplace_back("look.colour_by", overlays.colorBy);
    out.emplace_back("renderer", renderer);
    out.emplace_back("pixels", render::pixelClass(plan.picture.reproducible));
    return out;
}

std::vector<SettingChange> changesOf(const Settings& baseline, const Settings& actual) {
    const auto find = [](const Settings& in, const std::string& key) -> const std::string* {
        for (const auto& [name, value] : in)
            if (name == key) return &value;
        return nullptr;
    };
    std::vector<SettingChange> changes;
    for (const auto& [key, value] : actual) {
        const std::string* was = find(baseline, key);
        if (!was || *was != value) changes.push_back({key, was ? *was : "", value});
    }
    for (const auto& [key, value] : baseline)
        if (!find(actual, key)) changes.push_back({key, value, ""});
    return changes;
}

}  // namespace demos
