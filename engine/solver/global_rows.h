/// The constraints for a global solver: all rows in one list, in the order of a sweep of sequential impulses,
/// and the system that they form.
///   A lambda = zeta / h - J (v1 / h + M^-1 f_ext),   A = J M^-1 J^T,   zeta = -b
/// lambda is a force here, in N (N m). The input velocities already include the external forces, so the
/// second term in the bracket is part of the first. (First seed, 'Projected Gauss-Seidel'; Catto 2005.) An
/// impulse is h times the force.
#pragma once
#include "engine/solver/constraints.h"

namespace engine {

/// free: any lambda. push: lambda >= 0. hold: |lambda| <= most, a motor's strength. cone: this row and the
/// next are two tangents of a contact, for slip or for rolling, with |(lambda_1, lambda_2)| <= mu times the
/// sum of their normal forces.
enum class RowKind { free, push, hold, cone };

struct GlobalRow {
    Row row;
    int a = -1, b = -1;  // body numbers
    RowKind kind = RowKind::free;
    double softness = 0.0;                      // added to A's diagonal, 1/kg
    double most = 0.0;                          // hold, N (N m)
    const ConeMass* mass = nullptr;             // cone
    int normal = -1, normals = 0;               // cone: first row of its normal forces, and their number
    double mu = 0.0;                            // cone; m for rolling
    double bounce = 0.0;                        // cone: N s, along the normals from the impact pass
    int joint = -1;                             // index in the constraints' joints, or -1

    double diagonal() const { return row.k + softness; }
};

struct GlobalRows {
    std::vector<GlobalRow> rows;
    std::vector<double> wanted;  // the right-hand side, m/s^2 (rad/s^2)
    std::vector<double> force;   // lambda, N (N m)
    double h = 0.0;              // s

    int count() const { return static_cast<int>(rows.size()); }
    /// The largest force of a cone row and its partner, N (N m).
    double coneLimit(int i) const {
        const GlobalRow& row = rows[i];
        double load = 0.0;
        for (int k = 0; k < row.normals; ++k) load += force[row.normal + k];
        return row.mu * (load + row.bounce / h);
    }
};

/// Makes rows and right-hand side from the velocities before solving; the forces start from the impulses of
/// the last step, or from 0. Trees of joints are added row by row. Keeps pointers to the contact rows of `c`.
GlobalRows globalRows(const Constraints& c, std::span<const Velocity> v, const Settings& settings,
                      double h);

/// v += M^-1 J^T lambda
void addAlongRows(const GlobalRows& g, std::span<const double> lambda, std::span<Velocity> v);

/// Converts the forces to impulses of the constraints and applies them to the velocities.
void takeForces(const GlobalRows& g, Constraints& c, std::span<Velocity> v);

/// The force limited to the row's bounds; for every kind except cone.
inline double held(const GlobalRow& row, double force) {
    if (row.kind == RowKind::push) return larger(force, 0.0);
    return row.kind == RowKind::hold ? clamped(force, -row.most, row.most) : force;
}

/// One projected Gauss-Seidel sweep. `residual(i)` = the present wanted_i - (A lambda)_i without softness;
/// `moved(i, change)` is called for every change of a force.
template <class Residual, class Moved>
SweepReport sweepRows(GlobalRows& g, Residual residual, Moved moved) {
    Correction correction;
    const auto change = [&](int i, double force) {
        const double by = force - g.force[i];
        g.force[i] = force;
        moved(i, by);
        return by;
    };
    for (int i = 0; i < g.count(); ++i) {
        const GlobalRow& row = g.rows[i];
        if (row.kind == RowKind::cone) {
            const Vec2 force = solveInCone(*row.mass, {g.force[i], g.force[i + 1]},
                                           Vec2(-residual(i), -residual(i + 1)), g.coneLimit(i));
            const double first = change(i, force[0]), second = change(i + 1, force[1]);
            correction.add(*row.mass, g.h * Vec2(first, second));
            ++i;
        } else if (row.diagonal() > 0.0) {
            const double left = residual(i) - row.softness * g.force[i];
            const double force = g.force[i] + left / row.diagonal();
            const double by = change(i, held(row, force));
            correction.add(g.h * row.diagonal() * by, g.h * by);
        }
    }
    return {correction.velocity, correction.impulse};
}

}  // namespace engine
