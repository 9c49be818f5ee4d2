#include "engine/world_joints.h"

#include "engine/constraints/catmull_rom.h"
#include "engine/solver/drives.h"

namespace engine {
namespace {

Vec3 secondAxis(const JointDef& def) { return def.axis2.isZero(0.0) ? def.axis : def.axis2; }

/// The shortest rotation from h to k; if opposite, half a turn about any perpendicular axis.
Quat swingBetween(const Vec3& h, const Vec3& k) {
    const double c = h.dot(k);
    Vec3 across, other;
    tangents(h, across, other);
    const Vec3 axis = c > -1.0 + 1e-12 ? Vec3(h.cross(k)) : across;
    Quat q(c > -1.0 + 1e-12 ? 1.0 + c : 0.0, axis.x(), axis.y(), axis.z());
    q.normalize();
    return q;
}

void measurePath(const Pose& a, const Pose& b, Joint& joint) {
    const JointDef& def = joint.def;
    joint.lengths.assign(1, 0.0);
    for (int i = 0; i < pieces(def.path, def.closed); ++i)
        joint.lengths.push_back(joint.lengths.back() +
                                curveLength(def.path, def.closed, i, i + 1.0));
    joint.nearest = nearestOnCurve(def.path, def.closed, a.toLocal(b.toWorld(def.anchorB)));
}

/// The violation of limits of translations, m.
double beyondLimits(const Joint& joint, const Pose& a, const Pose& b) {
    double worst = 0.0;
    if (!joint.acts) return worst;
    const JointRows free = coordinatesOf(joint, a, b);
    for (int i = 0; i < free.count; ++i) {
        const Limits& limits = joint.def.free[i].limits;
        if (!limits.any() || free.j[i].linear.isZero(0.0)) continue;
        worst = larger(worst, larger(limits.low - free.error[i], free.error[i] - limits.high));
    }
    return worst;
}

bool holdsAPoint(JointType type) {
    return type == JointType::ball || type == JointType::hinge || type == JointType::weld ||
           type == JointType::universal || type == JointType::constantVelocity;
}

/// |C| of the rows measured in metres.
double missOf(const Joint& joint, const Pose& a, const Pose& b) {
    const JointDef& def = joint.def;
    if (rowCount(def) == 0) return 0.0;
    const double distance =
        (b.toWorld(def.anchorB) - a.toWorld(def.anchorA)).norm();
    if (def.type == JointType::distance) return std::abs(distance - def.length);
    if (holdsAPoint(def.type)) return distance;
    const JointRows rows = rowsOf(def.type, geometryOf(joint, a, b));
    double sum = 0.0;
    for (int i = 0; i < rows.count; ++i)
        if (!rows.j[i].linear.isZero(0.0)) sum += rows.error[i] * rows.error[i];
    return std::sqrt(sum);
}

/// The largest |C| of a joint of a tree, in lengths of its arms, or rad in a loop, where rotations may not fit.
double missedShare(const WorldState& s, const Joint& joint) {
    const JointDef& def = joint.def;
    if (!joint.present || treeRowsOf(def) == 0 || def.spring.isSoft()) return 0.0;
    const Pose &a = s.bodies.poses[def.a.index], &b = s.bodies.poses[def.b.index];
    const double arm = larger(larger(larger(def.anchorA.norm(), def.anchorB.norm()), def.length), 0.01);
    if (!joint.inLoop) return missOf(joint, a, b) / arm;
    double worst = 0.0;
    const JointRows rows = rowsOf(def.type, geometryOf(joint, a, b));
    for (int i = 0; i < rows.count; ++i)
        worst = larger(worst, std::abs(rows.error[i]) / (rows.j[i].linear.isZero(0.0) ? 1.0 : arm));
    return worst;
}

/// Joins the bodies that joints connect; `open`, by leader: whether one of these joints has not closed.
void findOpen(const WorldState& s, DisjointSets& sets, std::vector<char>& open) {
    constexpr double kClosed = 0.002, kClosedLoop = 0.0005;  // of the arms
    const int bodies = s.bodies.count();
    sets.reset(bodies);
    open.assign(bodies, 0);
    for (const Joint& joint : s.joints)
        if (joint.present && s.bodies.isDynamic(joint.def.a.index) && s.bodies.isDynamic(joint.def.b.index))
            sets.join(joint.def.a.index, joint.def.b.index);
    for (const Joint& joint : s.joints)
        if (missedShare(s, joint) > (joint.inLoop ? kClosedLoop : kClosed))
            open[sets.leaderOf(s.bodies.movable(joint.def.a.index, joint.def.b.index))] = 1;
}

/// Finds the joints of trees that are farther apart than the errors of a step, because not all constraints can
/// hold (solver/joint_forests.h). They stay torn until all joints connected with them have been closed for a
/// second: which of them does not close depends on how they are solved.
void findTorn(WorldState& s, double dt) {
    constexpr double kCalm = 1.0;  // s
    constexpr double kTorn = 0.02, kTornLoop = 0.002;  // of the arms; a loop that fits closes to round-off
    bool any = false;
    for (Joint& joint : s.joints) {
        const bool torn = missedShare(s, joint) > (joint.inLoop ? kTornLoop : kTorn);
        s.treesStale = s.treesStale || (torn && !joint.torn);
        if (torn) joint.calm = 0.0;
        joint.torn = joint.present && (joint.torn || torn);
        any = any || joint.torn;
    }
    if (!any) return;
    DisjointSets sets;
    std::vector<char> open;
    findOpen(s, sets, open);
    for (Joint& joint : s.joints) {
        if (!joint.torn) continue;
        const int leader = sets.leaderOf(s.bodies.movable(joint.def.a.index, joint.def.b.index));
        joint.calm = open[leader] ? 0.0 : joint.calm + dt;
        if (joint.calm < kCalm) continue;
        joint.torn = false;
        s.treesStale = true;
    }
}

}  // namespace

double separationOf(const WorldState& s, const Joint& joint) {
    const Pose &a = s.bodies.poses[joint.def.a.index], &b = s.bodies.poses[joint.def.b.index];
    return larger(missOf(joint, a, b), beyondLimits(joint, a, b));
}

Joint makeJoint(const WorldState& s, const JointDef& def) {
    Joint joint;
    joint.def = def;
    joint.acts = def.acts();
    const Pose &a = s.bodies.poses[def.a.index], &b = s.bodies.poses[def.b.index];
    const Quat &qa = a.rotation, &qb = b.rotation;
    Vec3 axis = def.axis.normalized(), axis2 = secondAxis(def).normalized();
    if (def.type == JointType::sixDof) {
        const bool world = def.axis2.isZero(0.0);
        axis = world ? Vec3(Vec3::UnitX()) : axis;
        axis2 = world ? Vec3(Vec3::UnitY()) : Vec3((axis2 - axis.dot(axis2) * axis).normalized());
    }
    joint.axisA = qa.conjugate() * axis;
    joint.axisB = qb.conjugate() * axis;
    joint.axis2A = qa.conjugate() * axis2;
    joint.axis2B = qb.conjugate() * axis2;
    joint.turnAtStart = qa.conjugate() * qb;
    if (def.type == JointType::constantVelocity || def.type == JointType::axis)
        joint.turnAtStart = qa.conjugate() * (swingBetween(axis2, axis) * qb);
    joint.startA = qa, joint.startB = qb;
    if (def.type == JointType::path) measurePath(a, b, joint);
    followCoordinates(joint, a, b);
    measureMasses(joint, s.bodies);
    return joint;
}

JointState stateOf(const WorldState& s, const Joint& joint) {
    JointState state;
    state.def = joint.def;
    state.removed = !joint.present;
    state.broken = joint.broken;
    const Pose &a = s.bodies.poses[joint.def.a.index], &b = s.bodies.poses[joint.def.b.index];
    state.worldA = a.toWorld(joint.def.anchorA);
    state.worldB = b.toWorld(joint.def.anchorB);
    state.worldAxis = a.rotation * joint.axisA;
    state.worldAxis2 = b.rotation * joint.axis2B;
    state.worldAxis2A = a.rotation * joint.axis2A;
    const JointRows free = coordinatesOf(joint, a, b);
    for (int i = 0; i < free.count; ++i) {
        state.positions[i] = free.error[i];
        state.speeds[i] = velocityAlong(free.j[i], s.bodies.velocities[joint.def.a.index],
                                        s.bodies.velocities[joint.def.b.index]);
    }
    state.position = state.positions[0];
    state.speed = state.speeds[0];
    state.separation = separationOf(s, joint);
    state.force = joint.force;
    state.torque = joint.torque;
    return state;
}

void followJoints(WorldState& s, double dt) {
    for (Joint& joint : s.joints) {
        const JointType type = joint.def.type;
        const bool counts = type == JointType::hinge || type > JointType::weld;
        if (joint.present && (counts || joint.acts))
            followCoordinates(joint, s.bodies.poses[joint.def.a.index],
                              s.bodies.poses[joint.def.b.index]);
    }
    findTorn(s, dt);
}

void findOnPaths(WorldState& s, int body) {
    for (Joint& joint : s.joints) {
        const JointDef& def = joint.def;
        if (!joint.present || def.type != JointType::path) continue;
        if (def.a.index != body && def.b.index != body) continue;
        const Pose &a = s.bodies.poses[def.a.index], &b = s.bodies.poses[def.b.index];
        joint.nearest = nearestOnCurve(def.path, def.closed, a.toLocal(b.toWorld(def.anchorB)));
    }
}

bool breakJoints(WorldState& s) {
    s.report.broken.clear();
    for (std::size_t i = 0; i < s.joints.size(); ++i) {
        Joint& joint = s.joints[i];
        if (!joint.present) joint.force = joint.torque = Vec3::Zero();  // removed since the last step
        const bool bears = joint.force.norm() <= joint.def.breakForce &&
                           joint.torque.norm() <= joint.def.breakTorque;
        if (!joint.present || bears) continue;
        joint.present = false;
        joint.broken = true;
        s.report.broken.push_back(s.jointId(static_cast<int>(i)));
        s.jointSlots.remove(static_cast<int>(i));
        for (const BodyId body : {joint.def.a, joint.def.b}) s.sleep.call(s.bodies, body.index);
        s.jointsStale = true;
    }
    return !s.report.broken.empty();
}

void wakeMotors(WorldState& s) {
    for (const Joint& joint : s.joints) {
        if (!joint.present || !joint.acts) continue;
        for (const Freedom& f : joint.def.free)
            if (f.motor.isOn() && f.motor.speed != 0.0)
                for (const BodyId body : {joint.def.a, joint.def.b})
                    s.sleep.call(s.bodies, body.index);
    }
}

bool hasMotors(const WorldState& s) {
    for (const Joint& joint : s.joints) {
        if (!joint.present || !joint.acts) continue;
        for (const Freedom& f : joint.def.free)
            if (f.motor.isOn()) return true;
    }
    return false;
}

}  // namespace engine
