#include "engine/solver/prepare_joints.h"

#include "engine/solver/drives.h"

namespace engine {

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
}

void prepareJoints(std::span<Joint> joints, const Bodies& bodies, const Settings& settings,
                   Solver& solver) {
    for (JointConstraint& c : solver.constraints.joints) {
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
    }
    solver.trees.prepare(joints, bodies);
    prepareDrives(joints, bodies, solver.constraints);
}

void groupJoints(const Bodies& bodies, Solver& solver) {
    Constraints& c = solver.constraints;
    const int groups = solver.groups.count();
    const auto groupOf = [&](int a, int b) {
        return solver.groups.ofJoint(a, b, bodies, solver.islands);
    };
    solver.trees.sortInto(groups, groupOf);
    c.jointsByGroup.sort(static_cast<int>(c.joints.size()), groups,
                         [&](int i) { return groupOf(c.joints[i].a, c.joints[i].b); });
    c.jointsOutside.sort(static_cast<int>(c.joints.size()), groups, [&](int i) {
        return c.joints[i].inTree ? -1 : groupOf(c.joints[i].a, c.joints[i].b);
    });
    c.drivesByGroup.sort(static_cast<int>(c.drives.size()), groups,
                         [&](int i) { return groupOf(c.drives[i].a, c.drives[i].b); });
    solver.treeDrives.sort(c, solver.trees, groups);
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
