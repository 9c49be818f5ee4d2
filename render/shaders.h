/// The texts of render/shaders, embedded at build time.
#pragma once
#include <string>

namespace render {

/// "solid.vert"; empty when there is none.
const char* shaderText(const std::string& name);

}  // namespace render
