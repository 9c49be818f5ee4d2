/// The verdict as report.json, for programs and for `impulse approve`.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "demos/regression/verdict.h"

namespace demos {

/// Of one scene: the object in report.json's "scenes".
nlohmann::ordered_json jsonOf(const SceneVerdict& scene);
/// Throws what nlohmann::json throws where something is missing or of another type.
SceneVerdict sceneVerdictFrom(const nlohmann::ordered_json& json);

std::string jsonOf(const TestVerdict& verdict);
/// Throws Stop (environment) where the text is no report.json of this version; `name`: of the file.
TestVerdict testVerdictFrom(const std::string& text, const std::string& name);

}  // namespace demos
