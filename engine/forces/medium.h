/// Air or water that moves, or stands still: drag that grows with the square of the speed, and what
/// the displaced medium weighs.
///   F_d = rho/2 C A |u| u,   u = (velocity of the medium) - v, A the body's shadow along u
///   F_b = -rho V g,          at the middle of the displaced volume V
/// Below a surface only the share of a body that is under it is dragged and carried. Falling in it
/// a body of mass m reaches v = sqrt(2 (m - rho V) g / (rho C A)).
#pragma once
#include <span>

#include "engine/force.h"
#include "engine/forces/force_moment.h"

namespace engine {

struct Bodies;

void addLoads(const Medium& medium, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads);

/// m^2: the shadow of a body in light along the unit vector `direction`.
double shadowOf(const Shape& shape, const Quat& rotation, const Vec3& direction);

}  // namespace engine
