/// Which OpenGL draws here.
#pragma once
#include <string>

#include "demos/options/options.h"

namespace demos {

/// The renderer's name, asked for in a process of its own: this one may not have a context. Throws
/// render::Error where there is no OpenGL.
std::string rendererName(const Options& options);

}  // namespace demos
