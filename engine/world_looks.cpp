#include "engine/world_looks.h"

#include <algorithm>

#include "engine/collision/centre_paths.h"
#include "engine/solver/prepare_contacts.h"
#include "engine/world_paces.h"

namespace engine {
namespace {

/// Whether the body belongs to islands that were reached; planes, which have no bounds, if they move.
bool isReached(WorldState& s, int body) {
    if (s.bodies.isDriven(body) && s.bodies.defs[body].shape.type == ShapeType::plane) return true;
    return s.bodies.mayWait(body) && s.reached[s.paces.setOf(body)];
}

void reach(WorldState& s, int body) {
    if (s.bodies.mayWait(body)) s.reached[s.paces.setOf(body)] = 1;
}

/// Marks what is where the body may get to within `time` (s), and `farther` (m), whatever hits it.
void reachFrom(WorldState& s, int body, double time, double farther) {
    const Bodies& bodies = s.bodies;
    const Shape& shape = bodies.defs[body].shape;
    if (!bodies.mayWait(body) || shape.type == ShapeType::plane) return;
    const Vec3& at = bodies.poses[body].position;
    const double way = time * bodies.velocities[body].linear.norm() + farther + reachOf(shape);
    const Bounds there = Bounds{at, at}.grownBy(way + s.settings.speculativeMargin);
    s.finder.broadPhase.tree().query(there, s.open, [&](int other) { reach(s, other); });
}

/// Marks all islands that fast bodies, and what they throw, may reach in a step of dt (s): from one island to the
/// next, because joints and contacts pass a hit on.
void reachFromFast(WorldState& s, double dt) {
    double farthest = 0.0;
    for (const int i : s.finder.moving.thrown) farthest = larger(farthest, s.finder.moving.throws[i]);
    for (const int i : s.fast) reach(s, i);
    s.spread.assign(s.bodies.count(), 0);
    for (bool any = true; any;) {
        any = false;
        for (const int i : s.bodies.active) {
            if (s.spread[i] || !isReached(s, i)) continue;
            reachFrom(s, i, dt, farthest);
            s.spread[i] = 1, any = true;
        }
    }
}

/// Who does not look keeps its contacts, like one that waits. Returns whether one looks that will not again.
bool chooseWhoLooks(WorldState& s, int substep, double left) {
    const bool all = substep % s.substepsALook == 0;
    s.reached.assign(s.bodies.count(), 0);
    for (const int i : s.turned) reach(s, i), reachFrom(s, i, left, 0.0);
    for (const int i : s.bodies.active)
        if (all && s.looks[i]) reach(s, i);
    bool last = false;
    for (const int i : s.bodies.active) {
        if (!s.bodies.mayWait(i)) continue;
        s.bodies.acts[i] = s.bodies.acts[i] && isReached(s, i);
        last = last || (s.bodies.acts[i] && !s.looks[i]);
        if (s.bodies.acts[i]) s.lookedAt[i] = substep;
    }
    return last;
}

/// Places the bodies that keep their contacts where they were when those were found, so that their rows are made as
/// then: an anchor on a rolling ball has left the floor since. With the velocities of then they need as many sweeps.
void goBackWithKept(WorldState& s) {
    s.keepers.clear();
    for (const int i : s.bodies.active) {
        if (!s.bodies.waits(i)) continue;
        s.keepers.push_back({i, s.bodies.poses[i], s.bodies.velocities[i]});
        s.bodies.poses[i] = s.solver.posesAtStart[i];
        if (s.lookedAt[i] == 0) s.bodies.velocities[i] = s.velocitiesBefore[i];
        updateInverseInertia(s.bodies, i);
    }
}

void bringBackKept(WorldState& s) {
    for (const auto& [body, pose, velocity] : s.keepers) {
        s.bodies.poses[body] = pose, s.bodies.velocities[body] = velocity;
        updateInverseInertia(s.bodies, body);
    }
    if (s.solver.lanes && !s.keepers.empty()) s.solver.wide.separateAll(s.bodies, s.settings.slop);
}

}  // namespace

int chooseLooks(WorldState& s, double dt) {
    s.looks.assign(s.bodies.count(), 0);
    s.lookedAt.assign(s.bodies.count(), 0);
    s.fast.clear();
    const int count = looksNeeded(s.finder.moving, s.bodies, dt, s.fast);
    if (count == 1) return 1;
    s.reached.assign(s.bodies.count(), 0);
    reachFromFast(s, dt);
    for (const int i : s.bodies.active) s.looks[i] = isReached(s, i);
    return count;
}

bool looksAgain(WorldState& s, int substep, double h) {
    s.turned.clear();
    if (substep == 0) return false;
    findWhoTurnsFar(s.finder.contacts, s.bodies, s.lookedAt, substep, h, s.turned);
    return substep % s.substepsALook == 0 || !s.turned.empty();
}

void findContactsWithin(WorldState& s, int substep, double h) {
    const double left = (s.report.substeps - substep) * h;
    const bool last = chooseWhoLooks(s, substep, left);
    keepSolved(s);
    storeImpulses(s.solver, s.finder.contacts);
    holdInFront(s.bodies, s.finder, s.solver.posesAtStart);
    findContacts(s, last ? left : s.substepsALook * h);
    if (s.finder.tooMany) s.report.trouble = Trouble::tooManyContacts;  // endStep undoes the step
    goBackWithKept(s);
    joinPaces(s, substep, s.report.substeps * h);
    prepareContacts(s.finder.contacts, s.joints, s.bodies, s.settings, s.solver);
    bringBackKept(s);
    beginSubstep(s, substep);
}

}  // namespace engine
