/// What Mesa reads from the environment: some changes pixels (GALLIUM_HUD draws on them), some
/// crashes the driver, some replaces our shaders. Only this program speaks to the driver.
#pragma once
#include <string_view>

#include "render/context.h"

namespace render {

/// Whether Mesa might listen to a variable of this name, which is then cleared.
bool isDriverVariable(std::string_view name);

/// Clears those of the user and sets ours. To be called before the first context of a process,
/// which is when the driver reads them.
void prepareDriverEnvironment(const ContextSettings& settings);

/// Which pixels this processor gives, where two may differ: "reproducible", else "fma" or "no fma".
const char* pixelClass(bool reproducible);

}  // namespace render
