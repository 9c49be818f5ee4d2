/// A soft row: instead of C = 0, a spring and a damper along it,
///   k = m w^2,  c = 2 m zeta w,  w = 2 pi hz,  m = 1 / K       k and c match the masses that the
///   row moves where the joint is made, unless the spring has its own
/// It changes the rate along the row, with the rate u before the sub-step's forces and v0 that everything else
/// leaves, to
///   v1 = E (v0 - D u - W C / h),   W = h^2 k / m,   d = h c / m
/// As a row, with lambda = m (v1 - v0) on top of the other impulses:
///   J v1 + b + gamma lambda = 0,   gamma = E K / (1 - E),   b = E (D u + W C / h) / (1 - E)
///
/// Springs::symplectic  E = 1 / (1 + d / 2),  D = d / 2: the spring pulls at C, the damper at the mean of u and
///                      v1. A swing keeps its amplitude where zeta = 0, and decays by e^(-zeta w t) with errors
///                      of (h w)^2; a weight sags by m g / k and falls with m g / c. Used for h w and d up
///                      to 0.2; above, it blends into the other scheme (fully from 0.4 on), stable at
///                      any stiffness:
/// Springs::implicit    E = 1 / (1 + d + W),  D = 0: the implicit-Euler spring to round-off, damped a little
///                      too much (a swing of 1.5 Hz by 80 % in 14 periods)
/// (Catto, GDC 2011, 'Soft Constraints'; Smith, Open Dynamics Engine, 'ERP and CFM'; Hairer, Lubich,
/// Wanner, 'Geometric Numerical Integration', I.1.)
#pragma once
#include "engine/constraints/jacobian.h"
#include "engine/joint.h"
#include "engine/settings.h"

namespace engine {

struct SoftRow {
    double softness = 0.0;  // gamma, 1/kg
    double bias = 0.0;      // beta C / h, m/s
};

/// v1 = kept (v0 - lag u - pull C / h)
struct SoftRate {
    double kept = 1.0, lag = 0.0, pull = 0.0;  // E, D, W
};

/// From W and d.
inline SoftRate softRate(double pull, double damping, Springs how) {
    const double stiff = larger(std::sqrt(pull), damping);
    const double share =
        how == Springs::symplectic ? clamped((stiff - 0.2) / 0.2, 0.0, 1.0) : 1.0;
    const double lag = 0.5 * (1.0 - share) * damping;
    return {1.0 / (1.0 + damping - lag + share * pull), lag, pull};
}

/// For a row with the inverse effective mass k, the error C and the rate u, and a step of length h.
inline SoftRow softRow(const Spring& spring, double k, double error, double before, double h, Springs how) {
    if (k <= 0.0) return {};
    const SoftRate rate =
        softRate(h * h * spring.stiffnessOf(k) * k, h * spring.resistanceOf(k) * k, how);
    const double taken = larger(1.0 - rate.kept, 1e-9);  // nearly zero for an undamped spring
    return {rate.kept * k / taken, rate.kept * (rate.lag * before + rate.pull * error / h) / taken};
}

/// lambda = -(J v + b + gamma lambda_total) / (K + gamma); with gamma = 0, that of the rigid row.
inline double correctiveImpulse(const Row& row, double bias, double softness, double total,
                                const Velocity& a, const Velocity& b) {
    if (row.k <= 0.0) return 0.0;
    return -(velocityAlong(row.j, a, b) + bias + softness * total) / (row.k + softness);
}

}  // namespace engine
