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

template <class Real>
struct SoftRow {
    Real softness = Real(0);  // gamma, 1/kg
    Real bias = Real(0);      // beta C / h, m/s
};

/// Of a row with the inverse effective mass k and the error C, for a step of length h.
template <class Real>
SoftRow<Real> softRow(const Spring& spring, Real k, Real error, Real h) {
    if (k <= Real(0)) return {};
    const auto inverseMass = static_cast<double>(k);
    const Real stiffness = static_cast<Real>(spring.stiffnessOf(inverseMass));
    const Real damping = static_cast<Real>(spring.resistanceOf(inverseMass));
    const Real softness = Real(1) / (h * (damping + h * stiffness));
    return {softness, error * h * stiffness * softness};
}

/// lambda = -(J v + b + gamma lambda_total) / (K + gamma); with gamma = 0 the rigid row's.
template <class Real>
Real correctiveImpulse(const Row<Real>& row, Real bias, Real softness, Real total,
                       const Velocity<Real>& a, const Velocity<Real>& b) {
    if (row.k <= Real(0)) return Real(0);
    return -(velocityAlong(row.j, a, b) + bias + softness * total) / (row.k + softness);
}

}  // namespace engine
