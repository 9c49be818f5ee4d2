/// The functions behind makeContext(). Each kind has its own source file and exists only if its kind
/// was built in.
#pragma once
#include <memory>

#include "render/context.h"

namespace render {

/// Both throw Error. The driver's environment must have been prepared before.
std::unique_ptr<Context> makeOsmesaContext();
std::unique_ptr<Context> makeEglContext();

/// See preloadContext(). Throws Error if OSMesa is not installed.
void loadOsmesaLibrary();

/// "renderer, version", as the current context reports them.
std::string describeOpenGl();

}  // namespace render
