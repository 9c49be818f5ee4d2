/// What a surface does to another. Two surfaces meet with friction sqrt(mu_a mu_b), the larger of the
/// two restitutions and the larger of the two resistances to rolling.
#pragma once

namespace engine {

/// Of the whole body.
struct Material {
    double density = 1000.0;   // kg/m^3, used where a body gives no mass
    double friction = 0.6;     // mu, Coulomb; 0 = ice
    double restitution = 0.0;  // e in 0..1: the share of the approach speed that comes back
    double rolling = 0.0;      // rho, m: rolling resistance, a moment of rho times the load
};

}  // namespace engine
