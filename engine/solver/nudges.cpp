#include "engine/solver/nudges.h"

#include "engine/dynamics/rotation.h"
#include "engine/solver/lanes.h"

namespace engine {
namespace {

constexpr double kMostNudge = 0.2;  // m: what one nudge may move, so that a deep error comes apart
                                    // over several steps and not through its neighbours

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

/// A joint outside the trees: row after row, the others' errors following to first order.
void nudgeJoint(const Joint& joint, Bodies& bodies, Solver& solver, const Settings& settings) {
    if (joint.def.spring.isSoft()) return;
    const int a = joint.def.a.index, b = joint.def.b.index;
    JointRows<double> rows =
        rowsOf(joint.def.type, geometryOf(joint, bodies.poses[a], bodies.poses[b]));
    Row<double> made[JointRows<double>::kMaxRows];
    for (int i = 0; i < rows.count; ++i)
        made[i] = makeRow(rows.j[i], bodies.inverseMasses[a], bodies.inverseMasses[b]);
    for (int i = 0; i < rows.count; ++i) {
        if (made[i].k <= 0.0) continue;
        const double c =
            clamped(settings.nudgeFactor * rows.error[i], -kMostNudge, kMostNudge);
        const double lambda = -c / made[i].k;
        nudge(made[i], lambda, a, b, bodies, solver);
        for (int k = i + 1; k < rows.count; ++k) rows.error[k] += coupling(made[i], made[k]) * lambda;
    }
}

/// How much of a tree's nudge becomes velocity: all while the errors are small against the arms,
/// nothing where the linear picture no longer holds.
double feedback(double worstRatio) { return clamped((0.04 - worstRatio) / 0.02, 0.0, 1.0); }

/// C of all trees' joints; returns the worst |C| / arm and the worst |C|.
std::pair<double, double> evaluateTrees(std::span<const Joint> joints, const Bodies& bodies,
                                        Solver& solver) {
    const std::vector<int>& order = solver.trees.order();
    solver.errors.assign(order.size() * JointTrees::kRows, 0.0);
    double worstRatio = 0.0, worst = 0.0;
    for (int place = 0; place < static_cast<int>(order.size()); ++place) {
        const JointConstraint<double>& c = solver.constraints.joints[order[place]];
        const Joint& joint = joints[c.joint];
        const JointGeometry<double> g = geometryOf(joint, bodies.poses[c.a], bodies.poses[c.b]);
        const JointRows<double> rows = rowsOf(joint.def.type, g);
        const double arm = larger(larger(g.armA.norm(), g.armB.norm()), joint.def.length);
        for (int i = 0; i < rows.count; ++i) {
            solver.errors[place * JointTrees::kRows + i] = rows.error[i];
            worst = larger(worst, std::abs(rows.error[i]));
            worstRatio = larger(worstRatio, std::abs(rows.error[i]) / larger(arm, 1e-3));
        }
    }
    return {worstRatio, worst};
}

void nudgeTrees(std::span<const Joint> joints, Bodies& bodies, Solver& solver, double h,
                bool feedBack) {
    const auto [ratio, worst] = evaluateTrees(joints, bodies, solver);
    const double share = worst > kMostNudge ? kMostNudge / worst : 1.0;
    for (double& c : solver.errors) c *= -share;
    solver.trees.solve(solver.errors);
    const double gain = feedBack ? feedback(ratio) / h : 0.0;
    const std::vector<int>& order = solver.trees.order();
    for (int place = 0; place < static_cast<int>(order.size()); ++place) {
        JointConstraint<double>& c = solver.constraints.joints[order[place]];
        for (int i = 0; i < c.count; ++i) {
            const double lambda = solver.errors[place * JointTrees::kRows + i];
            nudge(c.rows[i], lambda, c.a, c.b, bodies, solver);
            c.lambda[i] += gain * lambda;
            push(c, i, gain * lambda, bodies.velocities[c.a], bodies.velocities[c.b]);
        }
    }
}

void nudgeOnce(std::span<const Joint> joints, Bodies& bodies, Solver& solver,
               const Settings& settings, double h, bool first) {
    for (const JointConstraint<double>& c : solver.constraints.joints)
        if (!c.inTree) nudgeJoint(joints[c.joint], bodies, solver, settings);
    if (!solver.trees.empty()) nudgeTrees(joints, bodies, solver, h, first);
    if (solver.lanes && nudgeInLanes(solver, bodies, settings))
        solver.wide.separate(bodies, settings.slop);
    for (const int i : solver.constraints.order)
        nudgeContact(solver.constraints.contacts[i], bodies, solver, settings);
}

}  // namespace

void solveNudges(std::span<const Joint> joints, Bodies& bodies, Solver& solver,
                 const Settings& settings, double h) {
    solver.nudged.assign(bodies.count(), 0);
    if (solver.lanes && settings.nudges == 0) solver.wide.separate(bodies, settings.slop);
    for (int i = 0; i < settings.nudges; ++i)
        nudgeOnce(joints, bodies, solver, settings, h, i == 0);
    for (int i = 0; i < bodies.count(); ++i)
        if (solver.nudged[i]) updateInverseInertia(bodies, i);
    if (solver.constraints.joints.empty()) return;
    prepareJoints(joints, bodies, solver);
    if (settings.nudges == 0 || solver.trees.empty()) return;
    for (JointConstraint<double>& c : solver.constraints.joints) c.bias.fill(0.0);
    Correction<double> unused;
    solver.trees.solveVelocities(solver.constraints.joints, bodies.velocities, unused);
}

}  // namespace engine
