#include "engine/world_paces.h"

#include "engine/forces/force.h"
#include "engine/solver/drives.h"
#include "engine/solver/prepare_contacts.h"
#include "engine/world_looks.h"
#include "engine/world_sleep.h"

namespace engine {
namespace {

void findLinked(WorldState& s) {
    s.linked.clear();
    for (const std::optional<ForceDef>& force : s.forces) {
        if (!force || !linksBodies(*force)) continue;
        int last = -1;
        for (const BodyId id : force->on) {
            if (!s.bodies.mayWait(id.index)) continue;
            if (last >= 0) s.linked.push_back({last, id.index});
            last = id.index;
        }
    }
}

/// Velocities belong to half a sub-step ago (dynamics/energy.h), so they change with its length.
void setSpan(Bodies& bodies, int i, double span, double& scale) {
    const double before = bodies.spans[i];
    bodies.spans[i] = span;
    scale = before > 0.0 ? span / before : 1.0;
    if (before == 0.0 || before == span || !bodies.isDynamic(i)) return;
    bodies.velocities[i].linear += 0.5 * (before - span) * bodies.accelerations[i].linear;
    bodies.velocities[i].angular += 0.5 * (before - span) * bodies.accelerations[i].angular;
}

void scaleImpulses(WorldState& s) {
    const auto scaleOf = [&](int a, int b) { return s.scales[s.bodies.movable(a, b)]; };
    for (Contact& contact : s.finder.contacts) {
        const double scale = scaleOf(contact.a, contact.b);
        contact.rollingMoment *= scale;
        for (ContactPoint& point : contact.points) point.impulse *= scale, point.friction *= scale;
    }
    for (JointDrive& drive : s.solver.constraints.drives)
        for (DriveRow& row : drive.rows) row.lambda *= scaleOf(drive.a, drive.b);
    for (JointConstraint& joint : s.solver.constraints.joints)
        for (double& lambda : joint.lambda) lambda *= scaleOf(joint.a, joint.b);
    s.solver.trees.scaleImpulses(scaleOf);
}

/// A sleeping body keeps its sub-step length and the impulses that belong to it.
void setSpans(WorldState& s, double dt) {
    const double h = dt / s.report.substeps;
    bool any = false;
    s.scales.resize(s.bodies.count(), 1.0);
    for (const int i : s.bodies.active) {
        s.scales[i] = 1.0;
        if (!s.bodies.isMoving(i)) continue;
        setSpan(s.bodies, i, h * s.bodies.strides[i], s.scales[i]);
        any = any || s.scales[i] != 1.0;
    }
    if (!any) return;
    scaleImpulses(s);
    keepRates(s.solver.constraints, s.bodies);
}

/// Finds the connected bodies, those that share sub-steps, and the order of the contacts.
void arrangeContacts(WorldState& s) {
    connect(s.finder.contacts, s.joints, s.bodies, s.solver.islands);
    s.paces.link(s.solver.islands, {s.finder.contacts, s.joints, s.linked}, s.bodies);
    orderContacts(s.finder.contacts, s.bodies, s.gravity, s.settings.order, s.solver.keys,
                  s.solver.order);
}

void chooseStrides(WorldState& s, int i) {
    // An unknown force may depend on all bodies.
    const bool every = s.field || !s.settings.solvesByIsland();
    s.paces.choose(s.substeps, s.looks, {i, s.report.substeps, s.substepsALook, every}, s.bodies);
}

}  // namespace

void choosePaces(WorldState& s, double dt) {
    findLinked(s);
    arrangeContacts(s);
    const int needed = s.substeps.choose(s.solver.islands, s.finder.contacts, s.joints, s.bodies, s.solver,
                                         {s.gravity, s.settings, dt, s.velocitiesBefore});
    const int looks = chooseLooks(s, dt);
    s.substepsALook = (needed + looks - 1) / looks;
    s.report.substeps = s.substepsALook * looks;
    chooseStrides(s, 0);
    setSpans(s, dt);
    if (dt != s.lastDt) s.startOfPace = s.report.time, s.stepsAtPace = 0;
    s.lastDt = dt;
}

void joinPaces(WorldState& s, int i, double dt) {
    arrangeContacts(s);
    chooseStrides(s, i);
    setSpans(s, dt);
}

void beginSubstep(WorldState& s, int i) {
    for (const int k : s.bodies.active) s.bodies.acts[k] = i % s.bodies.strides[k] == 0;
    measureSprings(s.solver.constraints, s.bodies);
}

}  // namespace engine
