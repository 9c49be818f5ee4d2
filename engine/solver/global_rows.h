/// The constraints as a global solver sees them: all rows in one list, in the order in which a
/// sweep of sequential impulses comes by them, and the system that they have to meet together.
///   A lambda = zeta / h - J (v1 / h + M^-1 f_ext),   A = J M^-1 J^T,   zeta = -b
/// lambda is a force here, in N (N m). The velocities that come in have taken up the external
/// forces already, so the second term in the bracket is part of the first. (First seed, 'Projected
/// Gauss-Seidel'; Catto 2005.) An impulse is h times the force.
#pragma once
#include "engine/solver/constraints.h"

namespace engine {

/// free: any lambda. push: lambda >= 0. hold: |lambda| <= most, a motor's strength. cone: this row
/// and the next are two tangents of a contact, for slip or for turns, |(lambda_1, lambda_2)| <= mu times
/// the sum of the normal forces that hold them.
enum class RowKind { free, push, hold, cone };

template <class Real>
struct GlobalRow {
    Row<Real> row;
    int a = -1, b = -1;  // body numbers
    RowKind kind = RowKind::free;
    Real softness = Real(0);                    // added to A's diagonal, 1/kg
    Real most = Real(0);                        // hold, N (N m)
    const ConeMass<Real>* mass = nullptr;       // cone
    int normal = -1, normals = 0;               // cone: the first row that holds it, and how many do
    Real mu = Real(0);                          // cone; m where it is turns that are held
    Real bounce = Real(0);                      // cone: N s, along those from the impact pass
    int joint = -1;                             // its place in the constraints' joints, or -1

    Real diagonal() const { return row.k + softness; }
};

template <class Real>
struct GlobalRows {
    std::vector<GlobalRow<Real>> rows;
    std::vector<Real> wanted;  // the right-hand side, m/s^2 (rad/s^2)
    std::vector<Real> force;   // lambda, N (N m)
    Real h = Real(0);          // s

    int count() const { return static_cast<int>(rows.size()); }
    /// The largest force of a cone row and its partner, N (N m).
    Real coneLimit(int i) const {
        const GlobalRow<Real>& row = rows[i];
        Real load = Real(0);
        for (int k = 0; k < row.normals; ++k) load += force[row.normal + k];
        return row.mu * (load + row.bounce / h);
    }
};

/// Rows and right-hand side, from the velocities before solving; the forces start from the impulses
/// of the last step, or from 0. Trees of joints count row by row. Points to the contact rows of `c`.
template <class Real>
GlobalRows<Real> globalRows(const Constraints<Real>& c, std::span<const Velocity<Real>> v,
                            const Settings& settings, Real h);

/// v += M^-1 J^T lambda
template <class Real>
void addAlongRows(const GlobalRows<Real>& g, std::span<const Real> lambda,
                  std::span<Velocity<Real>> v);

/// The forces become impulses of the constraints, and change the velocities.
template <class Real>
void takeForces(const GlobalRows<Real>& g, Constraints<Real>& c, std::span<Velocity<Real>> v);

/// A force within the row's bounds; of any kind but cone.
template <class Real>
Real held(const GlobalRow<Real>& row, Real force) {
    if (row.kind == RowKind::push) return larger(force, Real(0));
    return row.kind == RowKind::hold ? clamped(force, -row.most, row.most) : force;
}

/// One projected Gauss-Seidel sweep. `residual(i)` = wanted_i - (A lambda)_i as it is now, without
/// the softness; `moved(i, change)` is told of every change of a force.
template <class Real, class Residual, class Moved>
SweepReport sweepRows(GlobalRows<Real>& g, Residual residual, Moved moved) {
    Correction<Real> correction;
    const auto change = [&](int i, Real force) {
        const Real by = force - g.force[i];
        g.force[i] = force;
        moved(i, by);
        return by;
    };
    for (int i = 0; i < g.count(); ++i) {
        const GlobalRow<Real>& row = g.rows[i];
        if (row.kind == RowKind::cone) {
            const Vec2T<Real> force = solveInCone<Real>(
                *row.mass, {g.force[i], g.force[i + 1]},
                Vec2T<Real>(-residual(i), -residual(i + 1)), g.coneLimit(i));
            const Real first = change(i, force[0]), second = change(i + 1, force[1]);
            correction.add(*row.mass, g.h * Vec2T<Real>(first, second));
            ++i;
        } else if (row.diagonal() > Real(0)) {
            const Real left = residual(i) - row.softness * g.force[i];
            const Real force = g.force[i] + left / row.diagonal();
            const Real by = change(i, held(row, force));
            correction.add(g.h * row.diagonal() * by, g.h * by);
        }
    }
    return {static_cast<double>(correction.velocity), static_cast<double>(correction.impulse)};
}

}  // namespace engine
