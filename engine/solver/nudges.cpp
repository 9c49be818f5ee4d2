#include "engine/solver/nudges.h"

#include <algorithm>

#include "engine/dynamics/rotation.h"
#include "engine/solver/joint_nudges.h"
#include "engine/solver/prepare_contacts.h"

namespace engine {
namespace {

/// x += M^-1 J^T lambda; q is rotated by I^-1 j lambda.
void nudge(const Row& row, double lambda, int a, int b, Bodies& bodies, std::vector<char>& pushed) {
    if (lambda == 0.0) return;
    const auto move = [&](int body, double mass, double sign, const Vec3& turn) {
        if (mass == 0.0) return;
        pushed[body] = 1;
        Pose& pose = bodies.poses[body];
        pose.position += (sign * mass * lambda) * row.j.linear;
        turnTo(cayley(lambda * turn, pose.rotation), body, bodies);
    };
    move(a, row.massA, -1.0, row.turnA);
    move(b, row.massB, 1.0, row.turnB);
}

/// The part of C that one nudge corrects: beta times the error beyond the slop.
double goal(double separation, const Settings& settings, double most) {
    const double beyond = separation + settings.slop;
    return beyond < 0.0 ? larger(settings.nudgeFactor * beyond, -most) : beyond;
}

/// True if it was deep enough to move its bodies.
bool nudgeContact(const ContactConstraint& contact, Bodies& bodies, Solver& solver,
                  const Settings& settings, double most) {
    Vec4 q = Vec4::Zero();
    bool any = false;
    for (int i = 0; i < contact.count; ++i) {
        q[i] = goal(separationNow(contact, contact.rows[i], bodies, solver), settings, most);
        any = any || q[i] < 0.0;
    }
    if (!any) return false;
    if (settings.block) {
        const Vec4 lambda = solveNormalBlock(contact.block, q);
        for (int i = 0; i < contact.count; ++i)
            nudge(rowAlong(contact, i, contact.n), lambda[i], contact.a, contact.b, bodies, solver.pushed);
        return true;
    }
    for (int i = 0; i < contact.count; ++i) {
        const Row row = rowAlong(contact, i, contact.n);
        const double lambda = q[i] < 0.0 && row.k > 0.0 ? -q[i] / row.k : 0.0;
        nudge(row, lambda, contact.a, contact.b, bodies, solver.pushed);
        for (int k = i + 1; k < contact.count; ++k)
            q[k] += coupling(row, rowAlong(contact, k, contact.n)) * lambda;
    }
    return true;
}

void move(int body, const WideVelocity& way, Bodies& bodies, std::vector<char>& pushed) {
    const Vec3 ahead = Eigen::Vector3f(way.linear).cast<double>();
    const Vec3 turn = Eigen::Vector3f(way.angular).cast<double>();
    if (ahead.isZero(0.0) && turn.isZero(0.0)) return;
    pushed[body] = 1;
    Pose& pose = bodies.poses[body];
    pose.position += ahead;
    turnTo(cayley(turn, pose.rotation), body, bodies);
}

/// Nudges all contacts in lanes once, if needed. True if bodies were moved.
bool nudgeInLanes(Solver& s, Bodies& bodies, const Settings& settings) {
    if (!s.wide.separate(bodies, settings.slop)) return false;
    const std::span<const WideVelocity> ways = s.wide.nudge(settings, kMostNudge);
    constexpr int kLeast = 512;  // bodies per thread
    const std::span<const int> active = bodies.active;
    s.workers.share(static_cast<int>(active.size()), kLeast, [&](int first, int end, int) {
        for (const int i : active.subspan(first, end - first))
            if (bodies.isActing(i)) move(i, ways[i], bodies, s.pushed);
    });
    return true;
}

/// True if any body was moved.
bool nudgeContacts(Bodies& bodies, Solver& solver, const Settings& settings, double h) {
    solver.pushed.resize(bodies.count());
    for (const int i : solver.groups.jointedBodies()) solver.pushed[i] = 0;
    const double speed = settings.depenetrationSpeed / settings.nudges;
    bool moved = solver.lanes && nudgeInLanes(solver, bodies, settings);
    for (const int i : solver.constraints.order) {
        const ContactConstraint& contact = solver.constraints.contacts[i];
        const double most = smaller(kMostNudge, speed * contact.stride * h);
        if (contact.stride > 0)
            moved = nudgeContact(contact, bodies, solver, settings, most) || moved;
    }
    for (JointGroup& group : solver.actingJoints)
        group.pushed = solver.byIsland ? std::ranges::any_of(solver.groups.jointedBodies(group.number),
                                                             [&](int body) { return solver.pushed[body] != 0; })
                                       : moved;
    return moved;
}

}  // namespace

void solveNudges(std::span<Joint> joints, Bodies& bodies, Solver& solver,
                 const Settings& settings, double h, int untilSeen) {
    TreeNudge nudge{kMostNudge, settings.gyroscope, true, false};
    const std::span<const JointGroup> jointed = solver.actingJoints;  // nudgeContacts() updates `pushed`
    for (const JointGroup& group : jointed) solver.trees.keepEnd(group.number, bodies.poses);
    solver.constraints.impacts.movePositions(bodies);
    bool pushed = false;  // by contacts
    for (int i = 0; i < settings.nudges; ++i) {
        // Joints first, so that they feed back only the error of the motion, not the pushes of
        // contacts.
        for (const JointGroup& group : jointed) {
            nudge.pushed = group.pushed;
            nudgeJoints(joints, bodies, solver, group.number, settings, h, nudge);
        }
        nudge.feeds = false;
        pushed = nudgeContacts(bodies, solver, settings, h);
    }
    nudge.pushed = true;
    for (const JointGroup& group : jointed)
        if (group.pushed) solver.trees.nudge(group.number, nudge, joints, bodies);
    updateInverseInertias(bodies);
    if (solver.lanes && (!jointed.empty() || pushed)) solver.wide.separate(bodies, settings.slop);
    for (const JointGroup& group : jointed)
        finishJoints(joints, bodies, solver, group.number, settings, group.stride >= untilSeen);
}

}  // namespace engine
