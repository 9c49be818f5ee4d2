/// The verdict as report.json, for programs and for `impulse approve`.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "demos/regression/verdict.h"

namespace demos {

/// One scene as an object of report.json's "scenes".
nlohmann::ordered_json jsonOf(const SceneVerdict& scene);
/// Throws what nlohmann::json throws if something is missing or has the wrong type.
SceneVerdict sceneVerdictFrom(const nlohmann::ordered_json& json);

std::string jsonOf(const TestVerdict& verdict);
/// Throws Stop (environment) if the text is not a report.json of this version; `name`: of the file.
TestVerdict testVerdictFrom(const std::string& text, const std::string& name);

}  // namespace demos
