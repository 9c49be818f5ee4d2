/// Air or water that moves, or stands still: drag that grows with the square of the speed, and what
/// the displaced medium weighs.
///   F_d = rho/2 C A |u| u,   u = (velocity of the medium) - v, A the body's shadow along u
///   F_b = -rho V g,          at the middle of the displaced volume V
/// Below a surface only the share of a body that is under it is dragged and carried. Falling in it
/// a body of mass m reaches v = sqrt(2 (m - rho V) g / (rho C A)).
#pragma once
#include <limits>
#include <span>

#include "engine/body.h"
#include "engine/forces/force_moment.h"

namespace engine {

struct Bodies;

struct Medium {
    static constexpr double kNoEnd = std::numeric_limits<double>::infinity();
    double density = 1.2;         // rho, kg/m^3
    Vec3 velocity{0, 0, 0};       // m/s: wind, current
    double dragCoefficient = 1.0; // C: 0.5 for a ball, 1 for a cube, 0 for no drag
    bool carries = true;          // buoyancy
    double level = kNoEnd;        // m, of its surface, against gravity (y without gravity)
    Vec3 low = Vec3::Constant(-kNoEnd);   // m, world axes: the medium fills the box from low to
    Vec3 high = Vec3::Constant(kNoEnd);   // high; a body is in it when its centre of mass is
};

void addLoads(const Medium& medium, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads);

/// m^2: the shadow of a body in light along the unit vector `direction`.
double shadowOf(const Shape& shape, const Quat& rotation, const Vec3& direction);

}  // namespace engine
