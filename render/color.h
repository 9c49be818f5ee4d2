/// The sRGB curve without pow: glibc's pow differs in its last bits from CPU to CPU.
#pragma once
#include "render/frame.h"

namespace render {

/// sRGB to linear light, 0..1, within 0.001 (cubic fit, Chapple 2011).
inline float toLinear(float c) { return c * (c * (c * 0.305306011f + 0.682171111f) + 0.012522878f); }

inline Color toLinear(const Color& c) { return {toLinear(c.r), toLinear(c.g), toLinear(c.b), c.a}; }

}  // namespace render
