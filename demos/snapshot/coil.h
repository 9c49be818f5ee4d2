/// A spring as a coil of rods, so that one sees how far it is drawn out.
#pragma once
#include "render/frame.h"

namespace demos {

constexpr int kCoilTurns = 9, kRodsPerTurn = 10;
constexpr int kCoilRods = kCoilTurns * kRodsPerTurn + 2;  // of a coil, one after the other

/// `rest`: m, its length without load; it sets how wide the coil is.
void addCoil(const render::Vec3& from, const render::Vec3& to, float rest, int id,
             render::Frame& frame);

}  // namespace demos
