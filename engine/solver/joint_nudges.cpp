#include "engine/solver/joint_nudges.h"

#include "engine/dynamics/rotation.h"
#include "engine/solver/drives.h"
#include "engine/solver/solve.h"
#include "engine/solver/nudges.h"
#include "engine/solver/prepare_joints.h"

namespace engine {
namespace {

/// Nudges a joint outside the trees, row by row; the errors of the others follow to first order.
void nudgeJoint(const Joint& joint, Bodies& bodies, const Settings& settings) {
    if (joint.def.spring.isSoft()) return;
    const int a = joint.def.a.index, b = joint.def.b.index;
    JointRows rows = rowsOf(joint.def.type, geometryOf(joint, bodies.poses[a], bodies.poses[b]));
    Row made[JointRows::kMaxRows];
    for (int i = 0; i < rows.count; ++i)
        made[i] = makeRow(rows.j[i], bodies.inverseMasses[a], bodies.inverseMasses[b]);
    Velocity wayA, wayB;  // m, rad
    for (int i = 0; i < rows.count; ++i) {
        if (made[i].k <= 0.0) continue;
        const double c = clamped(settings.nudgeFactor * rows.error[i], -kMostNudge, kMostNudge);
        const double lambda = -c / made[i].k;
        apply(made[i], lambda, wayA, wayB);
        for (int k = i + 1; k < rows.count; ++k) rows.error[k] += coupling(made[i], made[k]) * lambda;
    }
    moveBy(wayA, a, bodies);
    moveBy(wayB, b, bodies);
}

}  // namespace

void moveBy(const Velocity& way, int body, Bodies& bodies) {
    if (bodies.inverseMasses[body].linear == 0.0) return;
    Pose& pose = bodies.poses[body];
    pose.position += way.linear;
    pose.rotation = cayley(way.angular, pose.rotation);
}

void nudgeJoints(std::span<const Joint> joints, Bodies& bodies, Solver& solver,
                 const Settings& settings, double h, const TreeNudge& nudge) {
    for (const JointConstraint& c : solver.constraints.joints)
        if (!c.inTree) nudgeJoint(joints[c.joint], bodies, settings);
    // Limits after the trees, which feed back only the error of the motion.
    solver.trees.nudge(nudge, joints, bodies);
    if (!nudgeDrives(joints, bodies, solver.constraints, settings, h)) return;
    TreeNudge after = nudge;
    after.h = 0.0, after.pushed = true;
    solver.trees.nudge(after, joints, bodies);
}

void finishJoints(std::span<Joint> joints, Bodies& bodies, Solver& solver,
                  const Settings& settings, bool seen) {
    prepareJoints(joints, bodies, settings, solver);
    const bool linear = settings.gyroscope != Gyroscope::implicitEuler;
    const bool waits = !seen && linear && solvedAtOnce(solver);
    if (settings.nudges > 0 && !waits) solver.trees.projectVelocities(bodies.velocities);
}

}  // namespace engine
