/// A soft row: instead of C = 0, a spring and a damper along it, solved implicitly.
///   f = -k C1 - c dC1/dt,   C1 = C + h dC1/dt                   the force at the end of the step
///   lambda = h f  gives     J v1 + (beta / h) C + gamma lambda = 0
///   gamma = 1 / (h (c + h k)),   beta = h k / (c + h k)
///   k = m w^2,  c = 2 m zeta w,  w = 2 pi hz,  m = 1 / K       k and c suit the masses that the
///   row moves, unless the spring has its own
/// It is the implicit-Euler spring to round-off: stable at any stiffness, a little too well damped.
/// (Catto, GDC 2011, 'Soft Constraints'; Smith, Open Dynamics Engine, 'ERP and CFM'.)
#pragma once
#include "engine/constraints/jacobian.h"
#include "engine/joint.h"

namespace engine {

struct SoftRow {
    double softness = 0.0;  // gamma, 1/kg
    double bias = 0.0;      // beta C / h, m/s
};

/// Of a row with the inverse effective mass k and the error C, for a step of length h.
inline SoftRow softRow(const Spring& spring, double k, double error, double h) {
    if (k <= 0.0) return {};
    const auto inverseMass = k;
    const double stiffness = spring.stiffnessOf(inverseMass);
    const double damping = spring.resistanceOf(inverseMass);
    const double softness = 1.0 / (h * (damping + h * stiffness));
    return {softness, error * h * stiffness * softness};
}

/// lambda = -(J v + b + gamma lambda_total) / (K + gamma); with gamma = 0 the rigid row's.
inline double correctiveImpulse(const Row& row, double bias, double softness, double total,
                                const Velocity& a, const Velocity& b) {
    if (row.k <= 0.0) return 0.0;
    return -(velocityAlong(row.j, a, b) + bias + softness * total) / (row.k + softness);
}

}  // namespace engine
