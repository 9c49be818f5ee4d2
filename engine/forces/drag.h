/// Drag that grows with the speed, as of something small or slow in something thick.
///   F = -c v,   T = -k w
/// Alone it leaves v (1 - c h / m)^n after n sub-steps. One sub-step takes away the whole velocity
/// at most: a c above m / h stops the body and never turns it round.
#pragma once
#include <span>

#include "engine/force.h"
#include "engine/forces/force_moment.h"

namespace engine {

struct Bodies;

void addLoads(const Drag& drag, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads);

/// The largest c (N s/m) and k (N m s) that turn nothing round within a sub-step of h (s). k by the
/// trace of I^-1, which no axis exceeds.
double largestDrag(const Bodies& bodies, int body, double h);
double largestSpinDrag(const Bodies& bodies, int body, double h);

}  // namespace engine
