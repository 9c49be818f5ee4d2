/// How a picture looks: what was asked for on the command line, else what its scene says.
#pragma once
#include <string>

#include "demos/options/options.h"
#include "demos/scene/description.h"

namespace demos {

Paper paperOf(const Options& options);

/// --theme, else the scene's; a figure for paper is for print unless the scene says otherwise.
std::string themeOf(const SceneDescription& scene, const Options& options);

}  // namespace demos
