// What every file that has a scene would otherwise compile again: a tenth of the time of demos.
#include "demos/scene/description.h"

namespace demos {

BodyDescription::BodyDescription() = default;
BodyDescription::BodyDescription(const BodyDescription&) = default;
BodyDescription::BodyDescription(BodyDescription&&) noexcept = default;
BodyDescription& BodyDescription::operator=(const BodyDescription&) = default;
BodyDescription& BodyDescription::operator=(BodyDescription&&) noexcept = default;
BodyDescription::~BodyDescription() = default;

Section::Section() = default;
Section::Section(const Section&) = default;
Section::Section(Section&&) noexcept = default;
Section& Section::operator=(const Section&) = default;
Section& Section::operator=(Section&&) noexcept = default;
Section::~Section() = default;

SceneDescription::SceneDescription() = default;
SceneDescription::SceneDescription(const SceneDescription&) = default;
SceneDescription::SceneDescription(SceneDescription&&) noexcept = default;
SceneDescription& SceneDescription::operator=(const SceneDescription&) = default;
SceneDescription& SceneDescription::operator=(SceneDescription&&) noexcept = default;
SceneDescription::~SceneDescription() = default;

}  // namespace demos
