/// The look of a picture: set on the command line, else by its scene.
#pragma once
#include <string>

#include "demos/options/options.h"
#include "demos/scene/description.h"

namespace demos {

Paper paperOf(const Options& options);

/// --theme, else the scene's; "print" for a figure on paper unless the scene sets a theme.
std::string themeOf(const SceneDescription& scene, const Options& options);

}  // namespace demos
