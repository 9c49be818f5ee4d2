/// The properties of a surface. Two surfaces in contact combine to friction sqrt(mu_a mu_b), unless one has
/// another rule, the larger of the two restitutions and the larger of the two rolling resistances. If their
/// priorities differ, the one of higher priority alone determines all of these.
#pragma once

namespace engine {

/// How the friction coefficients of two surfaces are combined. Of two rules, the later in this list applies.
///   none       no friction, unless the other surface has another rule
///   geometric  sqrt(mu_a mu_b)
///   average    (mu_a + mu_b) / 2
///   smaller    min(mu_a, mu_b)
///   product    mu_a mu_b
///   larger     max(mu_a, mu_b)
/// (The order of the four common ones is that of the PhysX SDK, PxCombineMode.)
enum class FrictionRule { none, geometric, average, smaller, product, larger };

/// The surface of a whole body.
struct Material {
    double density = 1000.0;   // kg/m^3, used for bodies without a given mass
    double friction = 0.6;     // mu, Coulomb; 0 = ice
    double restitution = 0.0;  // e in 0..1: separation speed over approach speed
    double rolling = 0.0;      // rho, m: rolling resistance, a moment of rho times the load
    FrictionRule frictionRule = FrictionRule::geometric;
    int priority = 0;          // a surface of lower priority is ignored
};

}  // namespace engine
