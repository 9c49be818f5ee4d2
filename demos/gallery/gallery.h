/// impulse gallery: every scene's film and poster in a folder, and a page of them all.
#pragma once
#include "demos/options.h"
#include "demos/stop.h"

namespace demos {

/// What a scene that fails leaves out is told; the others are made. The code of the first failure.
/// Throws Stop (wouldOverwrite, interrupted), render::Error.
Exit galleryInFolder(const Options& options);

}  // namespace demos
