/// A run as arrays for numpy: np.load(FILE) returns them by name.
#pragma once
#include <cstdint>
#include <vector>

#include "demos/export/recording.h"

namespace demos {

/// F frames, B bodies, C contact points of all frames. Throws render::Error as zipOf() does.
std::vector<std::uint8_t> npzOf(const Recording& recording);

}  // namespace demos
