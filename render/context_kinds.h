/// The two makers behind makeContext(), each in a file of its own and only where it was built in.
#pragma once
#include <memory>

#include "render/context.h"

namespace render {

/// Both throw Error, and find the driver's environment prepared.
std::unique_ptr<Context> makeOsmesaContext();
std::unique_ptr<Context> makeEglContext();

/// "renderer, version", as the current context names them.
std::string describeOpenGl();

}  // namespace render
