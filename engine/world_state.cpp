#include "engine/world_state.h"

#include <algorithm>

#include "engine/collision/centre_paths.h"
#include "engine/forces/force.h"
#include "engine/solver/drives.h"
#include "engine/solver/prepare_contacts.h"
#include "engine/world_joints.h"
#include "engine/world_limits.h"
#include "engine/world_paces.h"
#include "engine/world_sleep.h"

namespace engine {
namespace {

/// Whether a joint leaves no freedom.
bool isRigid(const JointDef& def) {
    if (def.spring.isSoft()) return false;
    return def.type == JointType::weld ||
           (def.type == JointType::sixDof && std::ranges::all_of(def.free, &Freedom::locked));
}

/// Bodies joined by a joint do not collide with each other.
void listJointedPairs(WorldState& s) {
    std::vector<PairKey> joined, rigid;
    for (const Joint& joint : s.joints) {
        if (!joint.present) continue;
        joined.push_back({std::min(joint.def.a.index, joint.def.b.index),
                          std::max(joint.def.a.index, joint.def.b.index)});
        if (isRigid(joint.def)) rigid.push_back(joined.back());
    }
    s.finder.jointed.list(joined, rigid, s.bodies);
}

/// Tenfold energy in one step: only a kinematic body, a motor or an external force could add so much. It is
/// compared with the kinetic energy and 10 J/kg, because bodies at rest may fall, and Baumgarte's bias may
/// separate a deep overlap.
bool energyJumped(const WorldState& s, const Energy& before, const Energy& after) {
    if (hasMotors(s)) return false;
    double mass = 0.0;
    for (const int i : s.bodies.active) {
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

/// The start impulses of a point, as if it got them in every sub-step.
PointImpulses carried(const WorldState& s, const Contact& contact, int i) {
    const ContactPoint& point = contact.points[i];
    const double span = s.bodies.spans[s.bodies.movable(contact.a, contact.b)];
    const double substeps = span > 0.0 ? s.lastDt / span : s.report.substeps;
    return {point.impulse, substeps * point.impulse, point.friction, substeps * point.friction};
}

/// Lists the states of awake contacts, where got(k, i) gives the impulses of point i of contact k, and of
/// sleeping contacts, in the order of pairs.
template <class Got>
void listStates(const WorldState& s, std::span<const Contact> awake, std::span<const Pose> poses,
                Got got, std::vector<ContactState>& states) {
    auto next = s.finder.asleep.begin();
    const auto listAsleep = [&] {
        for (int i = 0; i < next->count; ++i)
            states.push_back(stateOf(s, *next, i, carried(s, *next, i), poses));
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

void updateJoints(WorldState& s, double dt) {
    if (!s.jointsStale && !s.treesStale) return;
    collectJoints(s.joints, s.bodies, s.settings, s.solver);
    prepareJoints(s.joints, s.bodies, s.settings, 0, s.solver);
    if (s.jointsStale) estimateTension(s.joints, s.bodies, s.gravity, s.solver, dt);
    s.jointsStale = s.treesStale = false;
}

}  // namespace

void findContacts(WorldState& s, double dt) {
    s.finder.moving.bounceSpeed = s.settings.bounce == Bounce::impacts ? s.settings.bounceSpeed : kFar;
    engine::findContacts(s.bodies, s.finder, s.settings.speculativeMargin, dt);
    s.contactsStale = false;
}

void goBack(WorldState& s) {
    for (const int i : s.bodies.active) {
        s.bodies.poses[i] = s.posesBefore[i];
        s.bodies.velocities[i] = s.velocitiesBefore[i];
        s.bodies.spans[i] = s.spansBefore[i];
        s.bodies.accelerations[i] = s.accelerationsBefore[i];
    }
    s.listed = WorldState::Listed::none;  // the impulses belong to an undone step
    s.touches.events.clear();
    for (const int i : s.bodies.active)
        if (s.bodies.present[i]) updateInverseInertia(s.bodies, i);
}

void removeBody(WorldState& s, BodyId id) {
    callAround(s, id.index);
    for (std::size_t i = 0; i < s.joints.size(); ++i)
        if (s.joints[i].present && (s.joints[i].def.a == id || s.joints[i].def.b == id)) {
            s.joints[i].present = false;
            s.jointSlots.remove(static_cast<int>(i));
        }
    for (std::optional<ForceDef>& force : s.forces)
        if (force) std::erase(force->on, id);  // its number may be reused
    s.bodySlots.remove(id.index);
    std::erase(s.untreed, id.index);
    s.bodies.present[id.index] = 0;
    s.bodies.activeShrinks = s.bodies.restStale = true;
    s.bodies.velocities[id.index] = {};
    s.bodies.inverseMasses[id.index] = {};
    s.finder.broadPhase.remove(id.index);
    std::erase_if(s.finder.contacts, [&](const Contact& c) {
        return c.a == id.index || c.b == id.index;
    });
    std::erase_if(s.finder.sensed, [&](const Sensed& o) {
        return o.pair.a == id.index || o.pair.b == id.index;
    });
    s.jointsStale = s.contactsStale = true;
}

bool beginStep(WorldState& s, double dt) {
    if (s.report.trouble != Trouble::none) return false;
    if (!s.again) {
        for (Slots* slots : {&s.bodySlots, &s.jointSlots, &s.forceSlots}) slots->beginStep();
        s.report.incidents.clear();
        s.tooFast.clear();
    }
    s.again = false;
    s.badlyLoaded.clear();
    callForced(s, dt);
    wakeCalled(s);
    limitSpeeds(s);
    leaveOutResting(s.bodies);
    beginSubstep(s, 0);
    if (s.jointsStale) listJointedPairs(s);
    if (s.contactsStale) findContacts(s, dt);
    if (s.finder.tooMany) {
        s.report.trouble = Trouble::tooManyContacts;
        return false;
    }
    updateSleep(s, dt);
    updateJoints(s, dt);
    choosePaces(s, dt);
    s.posesBefore.resize(s.bodies.count());
    s.velocitiesBefore.resize(s.bodies.count());
    s.spansBefore.resize(s.bodies.count());
    s.accelerationsBefore.resize(s.bodies.count());
    for (const int i : s.bodies.active) {
        s.posesBefore[i] = s.bodies.poses[i];
        s.velocitiesBefore[i] = s.bodies.velocities[i];
        s.spansBefore[i] = s.bodies.spans[i];
        s.accelerationsBefore[i] = s.bodies.accelerations[i];
    }
    s.solvedBefore.clear();
    s.kept.clear();
    sumResting(s.bodies);
    s.report.energy = energyNow(s);
    s.report.sweeps.clear();
    s.report.direct = {};
    prepareContacts(s.finder.contacts, s.joints, s.bodies, s.settings, s.solver);
    for (JointConstraint& joint : s.solver.constraints.joints)
        joint.totalImpulse.setZero(), joint.totalTwist.setZero();
    for (JointDrive& drive : s.solver.constraints.drives)
        drive.totalImpulse.setZero(), drive.totalTwist.setZero();
    s.solver.trees.beginStep();
    if (s.solver.constraints.ratesStale) keepRates(s.solver.constraints, s.bodies);
    return true;
}

void evaluateForces(const World& world, WorldState& s, int substep, double h) {
    if (!s.hasForces()) return;
    s.fieldLoads.assign(s.bodies.count(), {});
    if (s.field) s.call(s.field, world, std::span<Load>(s.fieldLoads));
    s.springs.assign(s.bodies.count(), 0);
    for (const std::optional<ForceDef>& force : s.forces)
        if (force && std::holds_alternative<SpringForce>(force->kind))
            for (const BodyId id : force->on) ++s.springs[id.index];
    const ForceMoment now{s.report.time + substep * h, h, s.gravity, s.springs};
    for (const std::optional<ForceDef>& force : s.forces)
        if (force) addLoads(*force, s.bodies, now, s.fieldLoads);
}

void keepSolved(WorldState& s) {
    const std::vector<Contact>& solved = s.finder.contacts;
    for (std::size_t k = 0; k < solved.size(); ++k)
        for (int i = 0; i < solved[k].count; ++i) {
            const PointImpulses got = impulsesOf(s.solver, int(k), i);
            const bool keeps = s.bodies.waits(solved[k].a, solved[k].b);
            if (keeps && got.total == 0.0) continue;  // it has not acted since
            s.solvedBefore.push_back(stateOf(s, solved[k], i, got, s.solver.posesAtStart));
        }
}

bool turnedTooFast(WorldState& s, double dt) {
    if (s.report.trouble != Trouble::none) return false;
    if (!s.substeps.raise(s.solver.islands, s.finder.contacts, s.bodies, s.solver,
                          {s.gravity, s.settings, dt, s.velocitiesBefore}))
        return false;
    goBack(s);
    s.contactsStale = std::ranges::any_of(s.lookedAt, [](int substep) { return substep > 0; });
    s.jointsStale = s.again = true;
    return true;
}

bool endStep(WorldState& s, double dt) {
    const Energy before = s.report.energy, after = energyNow(s);
    if (s.report.trouble != Trouble::none) {
        goBack(s);
        return false;
    }
    if (energyJumped(s, before, after)) s.report.incidents.push_back({Trouble::energyJump, {}});
    limitSpeeds(s);
    reportTooFast(s);
    storeImpulses(s.solver, s.finder.contacts);
    storeImpulses(s.solver, s.bodies, s.joints, dt);
    s.solver.pressed.unload(s.bodies);
    followJoints(s, dt);
    if (breakJoints(s)) listJointedPairs(s);
    s.listed = WorldState::Listed::solved;
    for (const int i : s.bodies.active) s.bodies.loads[i] = {};
    beginSubstep(s, 0);  // all are at the same time again
    holdInFront(s.bodies, s.finder, s.solver.posesAtStart);
    findContacts(s, dt);
    removeTheFar(s);
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
    s.contactsStale = true;  // the next step looks as far ahead as it is long, and sees the caller's changes
    s.report.energy = energyNow(s);
    s.listed = WorldState::Listed::found;
}

void listContacts(const WorldState& s, std::vector<ContactState>& states) {
    states.clear();
    if (s.listed == WorldState::Listed::kept) states = s.kept;
    const std::vector<Contact>& found = s.finder.contacts;
    // Step 6 has moved the solved contacts to `previous`, for their impulses.
    if (s.listed == WorldState::Listed::solved)
        listStates(
            s, s.finder.previous, s.solver.posesAtStart,
            [&](int k, int i) { return impulsesOf(s.solver, k, i); }, states);
    if (s.listed == WorldState::Listed::solved && !s.solvedBefore.empty()) {
        states.insert(states.end(), s.solvedBefore.begin(), s.solvedBefore.end());
        std::stable_sort(states.begin(), states.end(), [](const auto& p, const auto& q) {
            return std::pair(p.a.index, p.b.index) < std::pair(q.a.index, q.b.index);
        });
    }
    if (s.listed == WorldState::Listed::found)
        listStates(
            s, found, s.bodies.poses,
            [&](int k, int i) { return carried(s, found[k], i); }, states);
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
    Energy energy = energyOf(s.bodies, s.gravity);
    for (const Joint& joint : s.joints)
        if (joint.present && (joint.def.spring.isSoft() || joint.acts))
            energy.elastic += elasticEnergy(joint, s.bodies);
    for (const Joint& joint : s.joints)
        if (joint.present && joint.acts) energy.kinetic += rotorEnergy(joint, s.bodies);
    for (const std::optional<ForceDef>& force : s.forces)
        if (force && acts(*force, s.report.time, 0.0)) addPotential(*force, s.bodies, energy);
    return energy;
}

}  // namespace engine
