/// A spring as a coil of rods, so that its extension is visible.
#pragma once
#include "render/frame.h"

namespace demos {

/// `rest`: m, the length without load; it sets the coil's width. A coil that is small in the
/// picture of `frame.camera` gets few rods, a very small one is a bar.
void addCoil(const render::Vec3& from, const render::Vec3& to, float rest, int id,
             render::Frame& frame);

/// m: the radius of such a coil's wire.
float coilWire(float rest);

}  // namespace demos
