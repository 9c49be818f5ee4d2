/// Air or water, moving or at rest: drag that grows with the square of the speed, and the weight of
/// the displaced medium.
///   F_d = rho/2 C A |u| u,   u = (velocity of the medium) - v, A the area projected along u
///   F_b = -rho V g,          at the centroid of the displaced volume V
/// With a surface, drag and buoyancy act only on the submerged share of a body. A body of mass m
/// falling in the medium reaches v = sqrt(2 (m - rho V) g / (rho C A)).
#pragma once
#include <span>

#include "engine/force.h"
#include "engine/forces/force_moment.h"

namespace engine {

struct Bodies;

void addLoads(const Medium& medium, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads);

/// The area of a body projected along the unit vector `direction`, m^2.
double shadowOf(const Shape& shape, const Quat& rotation, const Vec3& direction);

}  // namespace engine
