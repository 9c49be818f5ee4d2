/// What a surface does to another. Two surfaces meet with friction sqrt(mu_a mu_b), unless a rule of
/// theirs says otherwise, the larger of the two restitutions and the larger of the two resistances to
/// rolling; where their priorities differ, the one of higher priority says all of it alone.
#pragma once

namespace engine {

/// How the friction of two surfaces is made of theirs. Of two rules the one further down counts.
///   none       no friction, unless the other surface's rule says how much
///   geometric  sqrt(mu_a mu_b)
///   average    (mu_a + mu_b) / 2
///   smaller    min(mu_a, mu_b)
///   product    mu_a mu_b
///   larger     max(mu_a, mu_b)
/// (The order of those four that others have as well: PhysX SDK, PxCombineMode.)
enum class FrictionRule { none, geometric, average, smaller, product, larger };

/// Of the whole body.
struct Material {
    double density = 1000.0;   // kg/m^3, used where a body gives no mass
    double friction = 0.6;     // mu, Coulomb; 0 = ice
    double restitution = 0.0;  // e in 0..1: the share of the approach speed that comes back
    double rolling = 0.0;      // rho, m: rolling resistance, a moment of rho times the load
    FrictionRule frictionRule = FrictionRule::geometric;
    int priority = 0;          // that of the other surface being lower, it has no say
};

}  // namespace engine
