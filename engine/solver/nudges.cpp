#include "engine/solver/nudges.h"

#include "engine/dynamics/rotation.h"
#include "engine/solver/joint_nudges.h"
#include "engine/solver/prepare_joints.h"

namespace engine {
namespace {

/// x += M^-1 J^T lambda, q turned by I^-1 j lambda.
void nudge(const Row<double>& row, double lambda, int a, int b, Bodies& bodies, Solver& solver) {
    if (lambda == 0.0) return;
    const auto move = [&](int body, double mass, double sign, const Vec3& turn) {
        if (mass == 0.0) return;
        Pose& pose = bodies.poses[body];
        pose.position += (sign * mass * lambda) * row.j.linear;
        pose.rotation = cayley(lambda * turn, pose.rotation);
        solver.nudged[body] = 1;
    };
    move(a, row.massA, -1.0, row.turnA);
    move(b, row.massB, 1.0, row.turnB);
}

/// The share of C that one nudge goes for: beta of what is beyond the slop.
double goal(double separation, const Settings& settings) {
    const double beyond = separation + settings.slop;
    return beyond < 0.0 ? larger(settings.nudgeFactor * beyond, -kMostNudge) : beyond;
}

void nudgeContact(const ContactConstraint<double>& contact, Bodies& bodies, Solver& solver,
                  const Settings& settings) {
    Vec4 q = Vec4::Zero();
    bool any = false;
    for (int i = 0; i < contact.count; ++i) {
        q[i] = goal(separationNow(contact, contact.rows[i], bodies, solver), settings);
        any = any || q[i] < 0.0;
    }
    if (!any) return;
    if (settings.block) {
        const Vec4 lambda = solveNormalBlock(contact.block, q);
        for (int i = 0; i < contact.count; ++i)
            nudge(rowAlong(contact, i, contact.n), lambda[i], contact.a, contact.b, bodies, solver);
        return;
    }
    for (int i = 0; i < contact.count; ++i) {
        const Row<double> row = rowAlong(contact, i, contact.n);
        const double lambda = q[i] < 0.0 && row.k > 0.0 ? -q[i] / row.k : 0.0;
        nudge(row, lambda, contact.a, contact.b, bodies, solver);
        for (int k = i + 1; k < contact.count; ++k)
            q[k] += coupling(row, rowAlong(contact, k, contact.n)) * lambda;
    }
}

void nudgeOnce(std::span<const Joint> joints, Bodies& bodies, Solver& solver,
               const Settings& settings, double h, bool first) {

    for (const int i : solver.constraints.order)
        nudgeContact(solver.constraints.contacts[i], bodies, solver, settings);
    nudgeJoints(joints, bodies, solver, settings, first ? h : 0.0);  // feed back only the first
}

}  // namespace

void solveNudges(std::span<const Joint> joints, Bodies& bodies, Solver& solver,
                 const Settings& settings, double h) {
    solver.nudged.assign(bodies.count(), 0);
    for (int i = 0; i < settings.nudges; ++i)
        nudgeOnce(joints, bodies, solver, settings, h, i == 0);
    for (int i = 0; i < bodies.count(); ++i)
        if (solver.nudged[i]) updateInverseInertia(bodies, i);
    if (solver.constraints.joints.empty()) return;
    prepareJoints(joints, bodies, settings, solver);
    if (settings.nudges > 0) solver.trees.projectVelocities(bodies.velocities);
}

}  // namespace engine
