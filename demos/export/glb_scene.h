/// A run as binary glTF 2.0: metres, seconds, y up, as the engine has them.
#pragma once
#include <cstdint>
#include <vector>

#include "demos/export/recording.h"

namespace demos {

/// One node per body, with its name; grounds as squares of 40 m; the camera and the sun. Bodies and
/// camera move as in the frames, linearly between them. Throws render::Error above 4 GiB.
std::vector<std::uint8_t> glbOf(const Recording& recording);

}  // namespace demos
