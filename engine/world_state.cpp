#include "engine/world_state.h"

#include <algorithm>

namespace engine {
namespace {

void findContacts(WorldState& s, double dt) {
    engine::findContacts(s.bodies, s.finder, s.settings.speculativeMargin, dt);
    s.contactsStale = false;
}

/// Bodies held together by a joint do not collide with each other.
void listJointedPairs(WorldState& s) {
    s.finder.jointed.clear();
    for (const Joint& joint : s.joints)
        if (joint.present)
            s.finder.jointed.push_back({std::min(joint.def.a.index, joint.def.b.index),
                                        std::max(joint.def.a.index, joint.def.b.index)});
    std::sort(s.finder.jointed.begin(), s.finder.jointed.end());
}

/// An impulse is a force times a sub-step; when that changes, so does what is carried over.
void rescaleImpulses(WorldState& s, double dt) {
    const double h = dt / s.report.substeps;
    const double before = s.lastSubsteps > 0 ? s.lastDt / s.lastSubsteps : h;
    if (h != before) {
        const double scale = h / before;
        for (Contact& contact : s.finder.contacts)
            for (ContactPoint& point : contact.points)
                point.impulse *= scale, point.friction *= scale;
        for (JointConstraint<double>& joint : s.solver.constraints.joints)
            for (double& lambda : joint.lambda) lambda *= scale;
        s.solver.trees.scaleImpulses(scale);
    }
    if (dt != s.lastDt) s.startOfPace = s.report.time, s.stepsAtPace = 0;
    s.lastDt = dt;
    s.lastSubsteps = s.report.substeps;
}

/// The first body whose state must not be passed on.
Trouble findTrouble(const WorldState& s, BodyId& who) {
    for (int i = 0; i < s.bodies.count(); ++i) {
        if (!s.bodies.isMoving(i)) continue;
        who = {i};
        const Pose& pose = s.bodies.poses[i];
        const Velocity<double>& v = s.bodies.velocities[i];
        if (!pose.position.allFinite() || !pose.rotation.coeffs().allFinite())
            return Trouble::positionNotFinite;
        if (!v.linear.allFinite() || !v.angular.allFinite()) return Trouble::velocityNotFinite;
        if (pose.position.cwiseAbs().maxCoeff() > 1e5) return Trouble::positionTooLarge;
        if (v.linear.cwiseAbs().maxCoeff() > 1e4 || v.angular.cwiseAbs().maxCoeff() > 1e4)
            return Trouble::velocityTooLarge;
    }
    who = {};
    return Trouble::none;
}

/// Ten times the energy in one step: nothing but a kinematic body or a force from outside has so
/// much to give. Measured against the kinetic energy and 10 J/kg: a start at rest may fall, and a
/// deep overlap be thrown out by Baumgarte's bias.
bool energyJumped(const WorldState& s, const Energy& before, const Energy& after) {
    double mass = 0.0;
    for (int i = 0; i < s.bodies.count(); ++i) {
        if (s.bodies.isMoving(i) && !s.bodies.isDynamic(i)) return false;
        if (!s.bodies.loads[i].force.isZero(0.0) || !s.bodies.loads[i].torque.isZero(0.0))
            return false;
        if (s.bodies.isDynamic(i)) mass += s.bodies.masses[i].mass;
    }
    const double gain = after.total() - before.total();
    return !s.field && gain > 10.0 * (before.kinetic + 10.0 * mass);
}

void goBack(WorldState& s) {
    s.bodies.poses = s.solver.posesAtStart;
    s.bodies.velocities = s.velocitiesBefore;
    s.contactStates.clear();  // the impulses of a step that did not happen
    s.statesStale = false;
    for (int i = 0; i < s.bodies.count(); ++i) updateInverseInertia(s.bodies, i);
}

}  // namespace

bool beginStep(WorldState& s, double dt) {
    if (s.report.trouble != Trouble::none) return false;
    if (s.jointsStale) {
        listJointedPairs(s);
        collectJoints(s.joints, s.bodies, s.settings, s.solver);
        prepareJoints(s.joints, s.bodies, s.settings, s.solver);
        estimateTension(s.joints, s.bodies, s.gravity, s.solver, dt);
        s.jointsStale = false;
    }
    if (s.contactsStale) findContacts(s, dt);
    s.report.substeps = chooseSubsteps(s.substeps, s.finder.contacts, s.joints, s.bodies, s.solver,
                                       s.settings, dt);
    rescaleImpulses(s, dt);
    s.velocitiesBefore = s.bodies.velocities;
    s.report.energy = energyNow(s);
    s.report.sweeps.clear();
    s.report.direct = {};
    prepareContacts(s.finder.contacts, s.joints, s.bodies, s.gravity, s.settings, s.solver);
    for (JointConstraint<double>& joint : s.solver.constraints.joints)
        joint.totalImpulse.setZero(), joint.totalTwist.setZero();
    s.solver.trees.beginStep();
    return true;
}

void evaluateField(const World& world, WorldState& s) {
    if (!s.field) return;
    s.fieldLoads.assign(s.bodies.count(), {});
    s.field(world, s.fieldLoads);
}

bool endStep(WorldState& s, double dt) {
    const Energy before = s.report.energy, after = energyNow(s);
    if (s.report.trouble == Trouble::none)
        s.report.trouble = findTrouble(s, s.report.troubledBody);
    if (s.report.trouble == Trouble::none && energyJumped(s, before, after))
        s.report.trouble = Trouble::energyJump;
    if (s.report.trouble != Trouble::none) {
        goBack(s);
        return false;
    }
    storeImpulses(s.solver, s.finder.contacts);
    storeImpulses(s.solver, s.bodies, s.joints, dt);
    s.statesStale = true;
    for (Load& load : s.bodies.loads) load = {};
    findContacts(s, dt);
    s.report.step += 1;
    s.report.time = s.startOfPace + static_cast<double>(++s.stepsAtPace) * dt;
    s.report.energy = after;
    s.report.residual = s.report.sweeps.empty() ? 0.0 : s.report.sweeps.back().residual;
    s.separationsStale = true;
    return true;
}

void refresh(WorldState& s) {
    if (!s.contactsStale) return;
    listJointedPairs(s);
    findContacts(s, s.lastDt);
    s.contactsStale = s.report.step > 0;  // the caller's changes still count for the next step
    s.report.energy = energyNow(s);
    reportSeparations(s);
    s.contactStates.clear();
    s.statesStale = false;
    for (const Contact& contact : s.finder.contacts)
        for (int i = 0; i < contact.count; ++i) {
            const Vec3 onA = s.bodies.poses[contact.a].toWorld(contact.points[i].anchorA);
            const Vec3 onB = s.bodies.poses[contact.b].toWorld(contact.points[i].anchorB);
            s.contactStates.push_back({{contact.a}, {contact.b}, 0.5 * (onA + onB), contact.normal,
                                       -contact.normal.dot(onB - onA), contact.points[i].impulse,
                                       contact.points[i].friction, contact.points[i].feature});
        }
}

void reportSeparations(WorldState& s) {
    s.separationsStale = false;
    s.report.worstPenetration = 0.0;
    s.report.contacts = 0;
    for (const Contact& contact : s.finder.contacts)
        for (int i = 0; i < contact.count; ++i) {
            const Vec3 onA = s.bodies.poses[contact.a].toWorld(contact.points[i].anchorA);
            const Vec3 onB = s.bodies.poses[contact.b].toWorld(contact.points[i].anchorB);
            const double c = contact.normal.dot(onB - onA);
            s.report.worstPenetration = larger(s.report.worstPenetration, -c);
            ++s.report.contacts;
        }
    s.report.worstSeparation = 0.0;
    for (const Joint& joint : s.joints)
        if (joint.present && !joint.def.spring.isSoft())
            s.report.worstSeparation =
                larger(s.report.worstSeparation, stateOf(s, joint).separation);
}

void listContacts(WorldState& s) {
    s.contactStates.clear();
    s.statesStale = false;
    // Step 6 has put the contacts that were solved aside, to remember their impulses by.
    for (int k = 0; k < static_cast<int>(s.finder.previous.size()); ++k) {
        const Contact& contact = s.finder.previous[k];
        for (int i = 0; i < contact.count; ++i) {
            const PointImpulses got = impulsesOf(s.solver, k, i);
            const ContactPoint& point = contact.points[i];
            const Vec3 onA = s.solver.posesAtStart[contact.a].toWorld(point.anchorA);
            const Vec3 onB = s.solver.posesAtStart[contact.b].toWorld(point.anchorB);
            s.contactStates.push_back({{contact.a}, {contact.b}, 0.5 * (onA + onB), contact.normal,
                                       -contact.normal.dot(onB - onA), got.total,
                                       got.totalFriction, point.feature});
        }
    }
}

Energy energyNow(const WorldState& s) {
    Energy energy = energyOf(s.bodies, s.gravity);
    for (const Joint& joint : s.joints)
        if (joint.present && joint.def.spring.isSoft())
            energy.elastic += elasticEnergy(joint, s.bodies);
    return energy;
}

Joint makeJoint(const WorldState& s, const JointDef& def) {
    Joint joint;
    joint.def = def;
    const Quat &qa = s.bodies.poses[def.a.index].rotation, &qb = s.bodies.poses[def.b.index].rotation;
    const Vec3 axis = def.axis.normalized();
    joint.axisA = qa.conjugate() * axis;
    joint.axisB = qb.conjugate() * axis;
    joint.turnAtStart = qa.conjugate() * qb;
    return joint;
}

JointState stateOf(const WorldState& s, const Joint& joint) {
    JointState state;
    state.def = joint.def;
    state.removed = !joint.present;
    const Pose &a = s.bodies.poses[joint.def.a.index], &b = s.bodies.poses[joint.def.b.index];
    state.worldA = a.toWorld(joint.def.anchorA);
    state.worldB = b.toWorld(joint.def.anchorB);
    const double distance = (state.worldB - state.worldA).norm();
    state.separation = joint.def.type == JointType::distance
                           ? std::abs(distance - joint.def.length)
                           : distance;
    state.force = joint.force;
    state.torque = joint.torque;
    return state;
}

}  // namespace engine
