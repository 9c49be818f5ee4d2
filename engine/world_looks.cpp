#include "engine/world_looks.h"

#include <algorithm>

#include "engine/collision/centre_paths.h"
#include "engine/solver/prepare_contacts.h"
#include "engine/world_paces.h"

namespace engine {
namespace {

constexpr char kReached = 1, kSpreads = 2, kHasSpread = 4;  // of a set of Paces

bool isReached(WorldState& s, int body) { return s.bodies.mayWait(body) && s.reached[s.paces.setOf(body)] > 0; }

void reach(WorldState& s, int body) {
    if (s.bodies.mayWait(body)) s.reached[s.paces.setOf(body)] |= kReached;
}

void beginReaching(WorldState& s) {
    s.reached.assign(s.bodies.count(), 0);
    s.bounds.resize(s.bodies.count());
    for (const int i : s.bodies.active)  // a moving plane has no bounds
        if (s.bodies.defs[i].shape.type == ShapeType::plane) reach(s, i);
}

/// Where the body may be within `time` (s), and `farther` (m), whatever hits it.
Bounds boundsWithin(const WorldState& s, int body, double time, double farther) {
    const Velocity& v = s.bodies.velocities[body];
    const double size = reachOf(s.bodies.defs[body].shape);
    const double way = time * (v.linear.norm() + v.angular.norm() * size) + farther + size;
    const Vec3& at = s.bodies.poses[body].position;
    return Bounds{at, at}.grownBy(way + s.settings.speculativeMargin);
}

/// Marks what is where bodies of the reached sets may be. True if there were sets that had not spread yet.
bool spread(WorldState& s, double time, double farther) {
    s.next.clear();
    for (const int i : s.bodies.active) {
        if (!s.bodies.mayWait(i) || s.bodies.defs[i].shape.type == ShapeType::plane) continue;
        const int set = s.paces.setOf(i);
        char& state = s.reached[set];
        if (state == 0 || (state & kHasSpread) != 0) continue;
        const Bounds there = boundsWithin(s, i, time, farther);
        s.bounds[set] = (state & kSpreads) != 0 ? s.bounds[set].with(there) : there;
        if ((state & kSpreads) == 0) s.next.push_back(set);
        state |= kSpreads;
    }
    for (const int set : s.next) s.reached[set] |= kHasSpread;
    for (const int set : s.next)
        s.finder.broadPhase.tree().query(s.bounds[set], s.open, [&](int other) { reach(s, other); });
    return !s.next.empty();
}

/// Who does not look keeps its contacts, like one that waits. Returns whether one looks that will not again.
bool chooseWhoLooks(WorldState& s, int substep, double left) {
    const bool all = substep % s.substepsALook == 0;
    s.everTurned.insert(s.everTurned.end(), s.turned.begin(), s.turned.end());
    beginReaching(s);
    for (const int i : all ? s.everTurned : s.turned) reach(s, i);
    spread(s, left, 0.0);
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
        s.bodies.velocities[i] = s.solver.velocitiesAtStart[i];
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
    s.fast.clear(), s.everTurned.clear();
    const int count = looksNeeded(s.finder.moving, s.bodies, dt, s.fast);
    if (count == 1) return 1;
    double farthest = 0.0;  // joints and contacts pass a hit on: from one set to the next
    for (const int i : s.finder.moving.thrown) farthest = larger(farthest, s.finder.moving.throws[i]);
    beginReaching(s);
    for (const int i : s.fast) reach(s, i);
    while (spread(s, dt, farthest)) {}
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
