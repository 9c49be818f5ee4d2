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

void nudgeJoints(std::span<const Joint> joints, Bodies& bodies, Solver& solver, int group,
                 const Settings& settings, double h, const TreeNudge& nudge) {
    const Constraints& c = solver.constraints;
    for (const int k : c.jointsOutside.of(group)) nudgeJoint(joints[c.joints[k].joint], bodies, settings);
    // Limits after the trees, which feed back only the error of the motion.
    solver.trees.nudge(group, nudge, joints, bodies);
    if (!nudgeDrives(joints, bodies, c, group, settings, h)) return;
    TreeNudge after = nudge;
    after.feeds = false, after.pushed = true;
    solver.trees.nudge(group, after, joints, bodies);
}

void finishJoints(std::span<Joint> joints, Bodies& bodies, Solver& solver, int group, const Settings& settings,
                  bool seen) {
    prepareJoints(joints, bodies, settings, group, solver);
    const bool linear = settings.gyroscope != Gyroscope::implicitEuler;
    const bool waits = !seen && linear && solver.byIsland && solvedAtOnce(solver, group);
    if (settings.nudges > 0 && !waits) solver.trees.projectVelocities(group, bodies.velocities);
}

}  // namespace engine
