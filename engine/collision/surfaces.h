/// Combines the materials of two surfaces that touch (material.h).
#pragma once
#include "engine/material.h"

namespace engine {

/// The combined material; its density is meaningless.
Material together(const Material& a, const Material& b);

}  // namespace engine
