/// The environment variables that Mesa reads: some change pixels (GALLIUM_HUD draws on them), some
/// crash the driver, some replace our shaders. Only this program may configure the driver.
#pragma once
#include <string_view>

#include "render/context.h"

namespace render {

/// Whether Mesa may read a variable of this name; such variables are cleared.
bool isDriverVariable(std::string_view name);

/// Clears the user's variables and sets ours. Call it before the first context of a process is
/// created: the driver reads them then.
void prepareDriverEnvironment(const ContextSettings& settings);

/// The class of processors that give the same pixels: "reproducible", "fma" or "no fma".
const char* pixelClass(bool reproducible);

}  // namespace render
