/// Two surfaces where they touch (material.h).
#pragma once
#include "engine/material.h"

namespace engine {

/// What holds between the two; of no meaning there: the density.
Material together(const Material& a, const Material& b);

}  // namespace engine
