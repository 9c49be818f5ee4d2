#include "engine/world_state.h"

#include <algorithm>

#include "engine/forces/force.h"
#include "engine/solver/prepare_contacts.h"
#include "engine/world_joints.h"
#include "engine/world_sleep.h"

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

void scaleImpulses(Joint& joint, double scale) {
    for (double& lambda : joint.lambda) lambda *= scale;
    for (double& lambda : joint.driven) lambda *= scale;
}

/// Velocities are those of half a sub-step ago (dynamics/energy.h); of a sub-step of another length.
void moveVelocities(Bodies& bodies, double time) {
    for (int i = 0; i < bodies.count(); ++i) {
        if (!bodies.isAwake(i)) continue;
        bodies.velocities[i].linear += time * bodies.accelerations[i].linear;
        bodies.velocities[i].angular += time * bodies.accelerations[i].angular;
    }
}

/// An impulse is a force times a sub-step; when that changes, so does what is carried over.
void rescaleImpulses(WorldState& s, double dt) {
    const double h = dt / s.report.substeps;
    const double before = s.lastSubsteps > 0 ? s.lastDt / s.lastSubsteps : h;
    if (h != before) {
        const double scale = h / before;
        for (std::vector<Contact>* contacts : {&s.finder.contacts, &s.finder.asleep})
            for (Contact& contact : *contacts) {
                contact.rollingMoment *= scale;
                for (ContactPoint& point : contact.points)
                    point.impulse *= scale, point.friction *= scale;
            }
        for (Joint& joint : s.joints)
            if (isAsleep(joint, s.bodies))
                scaleImpulses(joint, scale);
        for (JointDrive& drive : s.solver.constraints.drives)
            for (DriveRow& row : drive.rows) row.lambda *= scale;
        for (JointConstraint& joint : s.solver.constraints.joints)
            for (double& lambda : joint.lambda) lambda *= scale;
        s.solver.trees.scaleImpulses(scale);
        moveVelocities(s.bodies, s.lastSubsteps > 0 ? 0.5 * (before - h) : 0.0);
    }
    if (dt != s.lastDt) s.startOfPace = s.report.time, s.stepsAtPace = 0;
    s.lastDt = dt;
    s.lastSubsteps = s.report.substeps;
}

/// The first body whose state must not be passed on.
Trouble findTrouble(const WorldState& s, BodyId& who) {
    for (int i = 0; i < s.bodies.count(); ++i) {
        if (!s.bodies.isMoving(i)) continue;
        who = s.bodyId(i);
        const Pose& pose = s.bodies.poses[i];
        const Velocity& v = s.bodies.velocities[i];
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

/// Ten times the energy in one step: nothing but a kinematic body, a motor or a force from outside
/// has so much to give. Measured against the kinetic energy and 10 J/kg: a start at rest may fall,
/// and a deep overlap be thrown out by Baumgarte's bias.
bool energyJumped(const WorldState& s, const Energy& before, const Energy& after) {
    if (hasMotors(s)) return false;
    double mass = 0.0;
    for (int i = 0; i < s.bodies.count(); ++i) {
        if (s.bodies.isMoving(i) && !s.bodies.isDynamic(i)) return false;
        if (!s.bodies.loads[i].force.isZero(0.0) || !s.bodies.loads[i].torque.isZero(0.0))
            return false;
        if (s.bodies.isDynamic(i)) mass += s.bodies.masses[i].mass;
    }
    const double gain = after.total() - before.total();
    return !s.hasForces() && gain > 10.0 * (before.kinetic + 10.0 * mass);
}

ContactState stateOf(const WorldState& s, const Contact& contact, int i, const PointImpulses& got,
                     std::span<const Pose> poses) {
    const ContactPoint& point = contact.points[i];
    const Vec3 onA = poses[contact.a].toWorld(point.anchorA);
    const Vec3 onB = poses[contact.b].toWorld(point.anchorB);
    return {s.bodyId(contact.a), s.bodyId(contact.b), 0.5 * (onA + onB), contact.normal,
            -contact.normal.dot(onB - onA), got.total, got.totalFriction, point.feature};
}

/// What a point will start from, as if it got that in every sub-step.
PointImpulses carried(const ContactPoint& point, int substeps) {
    return {point.impulse, substeps * point.impulse, point.friction, substeps * point.friction};
}

/// States of the contacts awake, got(k, i) being what point i of contact k got, and of those asleep;
/// in the order of pairs.
template <class Got>
void listStates(const WorldState& s, std::span<const Contact> awake, std::span<const Pose> poses,
                Got got, std::vector<ContactState>& states) {
    auto next = s.finder.asleep.begin();
    const auto listAsleep = [&] {
        for (int i = 0; i < next->count; ++i)
            states.push_back(
                stateOf(s, *next, i, carried(next->points[i], s.report.substeps), poses));
        ++next;
    };
    for (int k = 0; k < static_cast<int>(awake.size()); ++k) {
        while (next != s.finder.asleep.end() && pairOf(*next) < pairOf(awake[k])) listAsleep();
        if (!s.bodies.present[awake[k].a] || !s.bodies.present[awake[k].b]) continue;
        for (int i = 0; i < awake[k].count; ++i)
            states.push_back(stateOf(s, awake[k], i, got(k, i), poses));
    }
    while (next != s.finder.asleep.end()) listAsleep();
}

void goBack(WorldState& s) {
    s.bodies.poses = s.solver.posesAtStart;
    s.bodies.velocities = s.velocitiesBefore;
    s.listed = WorldState::Listed::none;  // the impulses of a step that did not happen
    s.touches.events.clear();
    for (int i = 0; i < s.bodies.count(); ++i) updateInverseInertia(s.bodies, i);
}

void updateJoints(WorldState& s, double dt) {
    if (!s.jointsStale && !s.treesStale) return;
    collectJoints(s.joints, s.bodies, s.settings, s.solver);
    prepareJoints(s.joints, s.bodies, s.settings, s.solver);
    if (s.jointsStale) estimateTension(s.joints, s.bodies, s.gravity, s.solver, dt);
    s.jointsStale = s.treesStale = false;
}

}  // namespace

bool beginStep(WorldState& s, double dt) {
    if (s.report.trouble != Trouble::none) return false;
    for (Slots* slots : {&s.bodySlots, &s.jointSlots, &s.forceSlots}) slots->beginStep();
    callForced(s, dt);
    wakeCalled(s);
    if (s.jointsStale) listJointedPairs(s);
    if (s.contactsStale) findContacts(s, dt);
    updateSleep(s, dt);
    updateJoints(s, dt);
    s.report.substeps = chooseSubsteps(s.substeps, s.finder.contacts, s.joints, s.bodies, s.solver,
                                       s.settings, dt);
    rescaleImpulses(s, dt);
    s.velocitiesBefore = s.bodies.velocities;
    s.report.energy = energyNow(s);
    s.report.sweeps.clear();
    s.report.direct = {};
    prepareContacts(s.finder.contacts, s.joints, s.bodies, s.gravity, s.settings, s.solver);
    for (JointConstraint& joint : s.solver.constraints.joints)
        joint.totalImpulse.setZero(), joint.totalTwist.setZero();
    for (JointDrive& drive : s.solver.constraints.drives)
        drive.totalImpulse.setZero(), drive.totalTwist.setZero();
    s.solver.trees.beginStep();
    return true;
}

void evaluateForces(const World& world, WorldState& s, int substep, double h) {
    if (!s.hasForces()) return;
    s.fieldLoads.assign(s.bodies.count(), {});
    if (s.field) s.field(world, s.fieldLoads);
    const ForceMoment now{s.report.time + substep * h, h, s.gravity};
    for (const std::optional<ForceDef>& force : s.forces)
        if (force && acts(*force, now.time, h)) addLoads(*force, s.bodies, now, s.fieldLoads);
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
    followJoints(s);
    if (breakJoints(s)) listJointedPairs(s);
    s.listed = WorldState::Listed::solved;
    for (Load& load : s.bodies.loads) load = {};
    findContacts(s, dt);
    s.report.step += 1;
    s.report.time = s.startOfPace + static_cast<double>(++s.stepsAtPace) * dt;
    s.report.asleep = s.sleep.count();
    s.report.energy = after;
    for (JointId& id : s.report.direct.redundant) id = s.jointId(id.index);
    s.report.residual = s.report.sweeps.empty() ? 0.0 : s.report.sweeps.back().residual;
    if (s.touches.watched) recordTouches(s);
    for (Slots* slots : {&s.bodySlots, &s.jointSlots, &s.forceSlots}) slots->endStep();
    return true;
}

void findContactsNow(WorldState& s) {
    listJointedPairs(s);
    wakeCalled(s);
    findContacts(s, s.lastDt);
    s.contactsStale = s.report.step > 0;  // the caller's changes still count for the next step
    s.report.energy = energyNow(s);
    s.listed = WorldState::Listed::found;
}

void listContacts(const WorldState& s, std::vector<ContactState>& states) {
    states.clear();
    const std::vector<Contact>& found = s.finder.contacts;
    // Step 6 has put the contacts that were solved aside, to remember their impulses by.
    if (s.listed == WorldState::Listed::solved)
        listStates(
            s, s.finder.previous, s.solver.posesAtStart,
            [&](int k, int i) { return impulsesOf(s.solver, k, i); }, states);
    if (s.listed == WorldState::Listed::found)
        listStates(
            s, found, s.bodies.poses,
            [&](int k, int i) { return carried(found[k].points[i], s.report.substeps); }, states);
}

ErrorReport errorsOf(const WorldState& s) {
    ErrorReport errors;
    for (const std::vector<Contact>* contacts : {&s.finder.contacts, &s.finder.asleep})
        for (const Contact& contact : *contacts)
            for (int i = 0; i < contact.count; ++i) {
                const Vec3 onA = s.bodies.poses[contact.a].toWorld(contact.points[i].anchorA);
                const Vec3 onB = s.bodies.poses[contact.b].toWorld(contact.points[i].anchorB);
                errors.penetration = larger(errors.penetration, -contact.normal.dot(onB - onA));
                ++errors.contacts;
            }
    for (const Joint& joint : s.joints)
        if (joint.present && !joint.def.spring.isSoft())
            errors.separation = larger(errors.separation, separationOf(s, joint));
    return errors;
}

Energy energyNow(const WorldState& s) {
    const double h = s.lastSubsteps > 0 ? s.lastDt / s.lastSubsteps : 0.0;
    Energy energy = energyOf(s.bodies, s.gravity, h);
    for (const Joint& joint : s.joints)
        if (joint.present && (joint.def.spring.isSoft() || joint.acts))
            energy.elastic += elasticEnergy(joint, s.bodies, h);
    for (const std::optional<ForceDef>& force : s.forces)
        if (force && acts(*force, s.report.time, 0.0)) addPotential(*force, s.bodies, energy);
    return energy;
}

}  // namespace engine
