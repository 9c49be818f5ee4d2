#include "demos/scene/description.h"

namespace demos {

SceneDescription::SceneDescription() = default;
SceneDescription::SceneDescription(const SceneDescription&) = default;
SceneDescription::SceneDescription(SceneDescription&&) noexcept = default;
SceneDescription& SceneDescription::operator=(const SceneDescription&) = default;
SceneDescription& SceneDescription::operator=(SceneDescription&&) noexcept = default;
SceneDescription::~SceneDescription() = default;

}  // namespace demos
