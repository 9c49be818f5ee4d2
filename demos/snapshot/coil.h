/// A spring as a coil of rods, so that one sees how far it is drawn out.
#pragma once
#include "render/frame.h"

namespace demos {

/// `rest`: m, its length without load; it sets how wide the coil is. What is small in the picture
/// of `frame.camera` gets few rods.
void addCoil(const render::Vec3& from, const render::Vec3& to, float rest, int id,
             render::Frame& frame);

/// m: the radius of such a coil's wire.
float coilWire(float rest);

}  // namespace demos
