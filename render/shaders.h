/// The sources in render/shaders, embedded at build time.
#pragma once
#include <string>

namespace render {

/// The source of a file such as "solid.vert"; empty for an unknown name.
const char* shaderText(const std::string& name);

}  // namespace render
