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

#include "engine/body.h"
#include "engine/forces/force_moment.h"

namespace engine {

struct Bodies;

struct Airfoil {
    static constexpr double kStallWidth = 0.1;
    double area = 1.0;            // A, m^2
    Vec3 at{0, 0, 0};             // m, body axes: where the air's force acts
    Vec3 chord{1, 0, 0};          // unit, body axes: forwards, to the leading edge
    Vec3 normal{0, 1, 0};         // unit, body axes, across the chord: to the side lift acts to
    double density = 1.2;         // rho, kg/m^3
    Vec3 wind{0, 0, 0};           // m/s
    double liftSlope = 6.28318530717958648;  // a
    double stall = 0.26;          // rad
    double profileDrag = 0.02;    // C_0
    double plateDrag = 2.0;       // C_n
    double aspect = 8.0;          // AR, span^2 / area
};

/// C_L and C_D at the angle of which `cosine` and `sine` are given.
struct AirfoilCoefficients {
    double lift = 0.0, drag = 0.0;
};
AirfoilCoefficients coefficientsOf(const Airfoil& airfoil, double cosine, double sine);

void addLoads(const Airfoil& airfoil, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads);

}  // namespace engine
