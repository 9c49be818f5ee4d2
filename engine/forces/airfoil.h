/// A wing, a fin or a flat plate: lift and drag as functions of the angle of attack alpha, between
/// the chord and the incoming air, in the plane of chord and normal.
///   L = rho/2 |u|^2 A C_L across the flow,   D = rho/2 |u|^2 A C_D along it
///   attached   C_L = a sin(alpha),               C_D = C_0 + C_L^2 / (pi AR)
///   stalled    C_L = C_n sin(alpha) cos(alpha),  C_D = C_0 + C_n sin(alpha)^2
/// a = 2 pi is the flat plate of Kutta and Joukowski; a stalled plate has the pressure C_n
/// perpendicular to itself. The two are blended while sin(alpha) is up to kStallWidth beyond that
/// of the stall. The component of the flow along the span has no effect. `stall` = 0: never
/// attached, a plain surface.
#pragma once
#include <span>

#include "engine/force.h"
#include "engine/forces/force_moment.h"

namespace engine {

struct Bodies;

/// C_L and C_D at the angle given by its `cosine` and `sine`.
struct AirfoilCoefficients {
    double lift = 0.0, drag = 0.0;
};
AirfoilCoefficients coefficientsOf(const Airfoil& airfoil, double cosine, double sine);

void addLoads(const Airfoil& airfoil, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads);

}  // namespace engine
