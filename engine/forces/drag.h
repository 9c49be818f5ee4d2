/// Drag proportional to the speed, as for small or slow bodies in a viscous medium.
///   F = -c v,   T = -k w
/// Alone it leaves v (1 - c h / m)^n after n sub-steps. One sub-step removes at most the whole
/// velocity: c > m / h stops the body but never reverses it.
#pragma once
#include <span>

#include "engine/force.h"
#include "engine/forces/force_moment.h"

namespace engine {

struct Bodies;

void addLoads(const Drag& drag, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads);

/// The largest c (N s/m) and k (N m s) that do not reverse the motion within a sub-step of h (s). k
/// uses the trace of I^-1, which bounds it about every axis.
double largestDrag(const Bodies& bodies, int body, double h);
double largestSpinDrag(const Bodies& bodies, int body, double h);

}  // namespace engine
