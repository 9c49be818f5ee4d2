/// The name of the OpenGL renderer.
#pragma once
#include <string>

#include "demos/options/options.h"

namespace demos {

/// Gets the renderer's name in a process of its own, since this one may not have a context. Throws
/// render::Error if there is no OpenGL.
std::string rendererName(const Options& options);

}  // namespace demos
