#include "engine/solver/prepare_joints.h"

#include "engine/solver/chords.h"
#include "engine/solver/drives.h"

namespace engine {
namespace {

/// groupOf(a, b): by the bodies of a joint.
template <class GroupOf>
void sortInto(int groups, const GroupOf& groupOf, Solver& solver) {
    Constraints& c = solver.constraints;
    const int joints = static_cast<int>(c.joints.size()), drives = static_cast<int>(c.drives.size());
    solver.trees.sortInto(groups, groupOf);
    c.jointsByGroup.sort(joints, groups, [&](int i) { return groupOf(c.joints[i].a, c.joints[i].b); });
    c.jointsOutside.sort(joints, groups, [&](int i) {
        return c.joints[i].inTree ? -1 : groupOf(c.joints[i].a, c.joints[i].b);
    });
    c.drivesByGroup.sort(drives, groups, [&](int i) { return groupOf(c.drives[i].a, c.drives[i].b); });
    solver.treeDrives.sort(c, solver.trees, groups);
}

/// Of a rigid joint outside the trees.
void setBends(Joint& joint, const JointRows& now, const Bodies& bodies, JointConstraint& c) {
    c.bend.fill(0.0);
    if (c.inTree || c.spring.isSoft()) return;
    const Chord chord(bodies, c.a, c.b);
    if (chord.h == 0.0) return;
    const bool follows = joint.def.type == JointType::gear || joint.def.type == JointType::path;
    const auto nearest = joint.nearest;
    const auto position = joint.position;
    if (follows) followCoordinates(joint, chord.a, chord.b);
    const JointRows atEnd = rowsOf(joint.def.type, geometryOf(joint, chord.a, chord.b));
    joint.nearest = nearest, joint.position = position;
    for (int i = 0; i < c.count; ++i) {
        const double rate = velocityAlong(now.j[i], bodies.velocities[c.a], bodies.velocities[c.b]);
        c.bend[i] = chord.bend(atEnd.error[i], now.error[i], rate);
    }
}

}  // namespace

void collectJoints(std::span<Joint> joints, const Bodies& bodies, const Settings& settings,
                   Solver& solver) {
    std::vector<JointConstraint>& list = solver.constraints.joints;
    list.clear();
    solver.constraints.drives.clear();
    solver.constraints.ratesStale = true;
    for (int i = 0; i < static_cast<int>(joints.size()); ++i) {
        joints[i].inLoop = false;
        if (!joints[i].present || isAsleep(joints[i], bodies)) continue;
        const JointDef& def = joints[i].def;
        if (def.acts()) solver.constraints.drives.push_back(makeDrive(joints[i], i));
        if (rowCount(def) == 0) continue;
        JointConstraint joint;
        joint.a = def.a.index, joint.b = def.b.index;
        joint.joint = i;
        joint.count = rowCount(def);
        joint.spring = def.spring;
        for (int k = 0; k < joint.count; ++k)
            joint.springs[k] = def.spring.fixedFor(joints[i].rowMasses[k]);
        joint.asBlock = def.type > JointType::weld;
        joint.treeRows = treeRowsOf(def);
        joint.isGear = def.type == JointType::gear;
        joint.torn = joints[i].torn;
        joint.lambda = joints[i].lambda;
        list.push_back(joint);
    }
    if (settings.method == Method::impulses && settings.joints == JointSolving::direct)
        solver.trees.build(list, joints, bodies.inverseMasses);
    else
        solver.trees = {};
    for (const int i : solver.trees.inLoops()) joints[list[i].joint].inLoop = true;
    for (int i = 0; i < static_cast<int>(joints.size()); ++i)
        joints[i].solvedAtOnce = solver.trees.exactTreeOf(i) >= 0;
    sortInto(1, [](int, int) { return 0; }, solver);
}

void prepareJoints(std::span<Joint> joints, const Bodies& bodies, const Settings& settings, int group,
                   Solver& solver) {
    for (const int k : solver.constraints.jointsByGroup.of(group)) {
        JointConstraint& c = solver.constraints.joints[k];
        Joint& joint = joints[c.joint];
        if (joint.def.type == JointType::gear || joint.def.type == JointType::path)
            followCoordinates(joint, bodies.poses[c.a], bodies.poses[c.b]);
        if (c.inTree && !settings.compareExact) continue;
        JointRows rows =
            rowsOf(joint.def.type, geometryOf(joint, bodies.poses[c.a], bodies.poses[c.b]));
        c.count = rows.count;
        for (int i = 0; i < rows.count; ++i) {
            if (joint.def.spring.isSoft()) rows.fade(i);
            c.rows[i] = makeRow(rows.j[i], bodies.inverseMasses[c.a], bodies.inverseMasses[c.b]);
            c.error[i] = rows.error[i];
        }
        setBends(joint, rows, bodies, c);
    }
    solver.trees.prepare(group, joints, bodies);
    prepareDrives(joints, bodies, group, solver.constraints);
}

void groupJoints(const Bodies& bodies, Solver& solver) {
    const auto groupOf = [&](int a, int b) {
        return solver.groups.ofJoint(a, b, bodies, solver.islands);
    };
    sortInto(solver.groups.count(), groupOf, solver);
}

void chooseActingJoints(const Bodies& bodies, Solver& solver) {
    Constraints& c = solver.constraints;
    const auto strideOf = [&](int body) { return bodies.acts[body] ? bodies.strides[body] : 0; };
    for (JointConstraint& joint : c.joints) joint.stride = strideOf(bodies.movable(joint.a, joint.b));
    for (JointDrive& drive : c.drives) drive.stride = strideOf(bodies.movable(drive.a, drive.b));
    solver.actingJoints.clear();
    if (!solver.byIsland) {
        if (!c.joints.empty() || !c.drives.empty()) solver.actingJoints.push_back({});
        return;
    }
    const ContactGroups& groups = solver.groups;
    for (int g = 0; g < groups.count() && groups.hasJoints(g); ++g)
        if (const int stride = strideOf(groups.bodyOf(g)); stride > 0)
            solver.actingJoints.push_back({g, stride});
}

double elasticEnergy(const Joint& joint, const Bodies& bodies) {
    const double h = bodies.spans[bodies.movable(joint.def.a.index, joint.def.b.index)];
    double energy = joint.acts ? driveEnergy(joint, bodies, h) : 0.0;
    if (!joint.def.spring.isSoft()) return energy;
    const int a = joint.def.a.index, b = joint.def.b.index;
    JointRows rows =
        rowsOf(joint.def.type, geometryOf(joint, bodies.poses[a], bodies.poses[b]));
    for (int i = 0; i < rows.count; ++i) {
        rows.fade(i);
        const double k =
            makeRow(rows.j[i], bodies.inverseMasses[a], bodies.inverseMasses[b]).k;
        const double rate = velocityAlong(rows.j[i], bodies.velocities[a], bodies.velocities[b]);
        const double stretch = rows.error[i] - 0.5 * h * rate;
        const double stiffness = joint.def.spring.fixedFor(joint.rowMasses[i]).stiffness;
        if (k > 0.0) energy += 0.5 * stiffness * stretch * stretch;
    }
    return energy;
}

void storeImpulses(const Solver& solver, const Bodies& bodies, std::span<Joint> joints, double dt) {
    for (const JointDrive& drive : solver.constraints.drives)
        joints[drive.joint].force = joints[drive.joint].torque = Vec3::Zero();
    for (const JointConstraint& c : solver.constraints.joints) {
        if (c.inTree) continue;
        Joint& joint = joints[c.joint];
        const Vec3 armB = bodies.poses[c.b].rotation * joint.def.anchorB;
        joint.lambda = c.lambda;
        joint.force = c.totalImpulse / dt;
        joint.torque = c.totalTwist / dt - armB.cross(joint.force);
    }
    solver.trees.report(joints, dt);
    storeDrives(solver.constraints, bodies, joints, dt);
}

}  // namespace engine
