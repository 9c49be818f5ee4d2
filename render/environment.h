/// What llvmpipe reads from the environment when the first context of a process is made.
#pragma once
#include "render/renderer.h"

namespace render {

/// Clears LP_*, GALLIUM_*, GALLIVM_* and DRAW_USE_LLVM (some values crash Mesa, others change
/// pixels) and sets what `settings` asks for. Mesa reads them once: a later call of the same
/// process that asks for something else throws Error.
void prepareEnvironment(const RendererSettings& settings);

}  // namespace render
