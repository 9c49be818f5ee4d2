/// A wing, a fin or a flat plate: lift and drag against the angle of attack alpha, between the
/// chord and the air that comes towards it, in the plane of chord and normal.
///   L = rho/2 |u|^2 A C_L across the air,   D = rho/2 |u|^2 A C_D along it
///   attached   C_L = a sin(alpha),               C_D = C_0 + C_L^2 / (pi AR)
///   stalled    C_L = C_n sin(alpha) cos(alpha),  C_D = C_0 + C_n sin(alpha)^2
/// a = 2 pi is the flat plate of Kutta and Joukowski; stalled, the plate feels the pressure C_n
/// across itself. One passes into the other while sin(alpha) goes kStallWidth beyond that of the
/// stall. The component of the air along the span does nothing. `stall` = 0: never attached, a mere
/// surface.
#pragma once
#include <span>

#include "engine/force.h"
#include "engine/forces/force_moment.h"

namespace engine {

struct Bodies;

/// C_L and C_D at the angle of which `cosine` and `sine` are given.
struct AirfoilCoefficients {
    double lift = 0.0, drag = 0.0;
};
AirfoilCoefficients coefficientsOf(const Airfoil& airfoil, double cosine, double sine);

void addLoads(const Airfoil& airfoil, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads);

}  // namespace engine
