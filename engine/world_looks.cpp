#include "engine/world_looks.h"

#include <algorithm>

#include "engine/collision/centre_paths.h"
#include "engine/solver/prepare_contacts.h"
#include "engine/world_paces.h"

namespace engine {
namespace {

/// Where a body may be within dt (s), whatever hits it in that time.
Bounds reachOf(const WorldState& s, int body, double dt) {
    const Motion& motion = s.finder.moving.motions[body];
    const double way = dt * motion.velocity.norm() + s.finder.moving.throws[body] + motion.size;
    const Bounds there{motion.start.position, motion.start.position};
    return there.grownBy(way + s.settings.speculativeMargin);
}

bool isReached(WorldState& s, int body) {
    return s.bodies.isMoving(body) && s.reach.islands[s.solver.islands.leaderOf(body)];
}

void reach(WorldState& s, int body) {
    if (s.bodies.isMoving(body)) s.reach.islands[s.solver.islands.leaderOf(body)] = 1;
}

/// Marks the islands that these bodies may reach within dt (s), and those reached from there by thrown bodies.
void findReached(WorldState& s, const std::vector<int>& from, double dt) {
    Reach& r = s.reach;
    r.islands.assign(s.bodies.count(), 0);
    r.next.assign(from.begin(), from.end());
    r.thrown.assign(s.finder.moving.thrown.begin(), s.finder.moving.thrown.end());
    for (const int i : r.next) reach(s, i);
    while (!r.next.empty()) {
        for (const int i : r.next)
            if (s.bodies.isMoving(i))
                s.finder.broadPhase.tree().query(reachOf(s, i, dt), r.open, [&](int other) { reach(s, other); });
        const auto rest = std::partition(r.thrown.begin(), r.thrown.end(), [&](int i) { return !isReached(s, i); });
        r.next.assign(rest, r.thrown.end());
        r.thrown.erase(rest, r.thrown.end());
    }
}

}  // namespace

int chooseLooks(WorldState& s, double dt) {
    s.fast.clear();
    const int count = looksNeeded(s.finder.moving, s.bodies, dt, s.fast);
    s.looks.assign(s.bodies.count(), 0);
    s.lookedAt.assign(s.bodies.count(), 0);
    if (count == 1) return 1;
    findReached(s, s.fast, dt);
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
    findReached(s, s.turned, (s.report.substeps - substep) * h);
    const bool all = substep % s.substepsALook == 0;
    for (const int i : s.bodies.active)  // who does not look keeps its contacts, like one that waits
        s.bodies.acts[i] = s.bodies.acts[i] && ((all && s.looks[i]) || isReached(s, i));
    for (const int i : s.bodies.active)
        if (!s.bodies.waits(i)) s.lookedAt[i] = substep;
    keepSolved(s);
    storeImpulses(s.solver, s.finder.contacts);
    holdInFront(s.bodies, s.finder, s.solver.posesAtStart);
    findContacts(s, s.substepsALook * h);
    if (s.finder.tooMany) s.report.trouble = Trouble::tooManyContacts;  // endStep undoes the step
    joinPaces(s, substep, s.report.substeps * h);
    beginSubstep(s, substep);
    prepareContacts(s.finder.contacts, s.joints, s.bodies, s.settings, s.solver);
}

}  // namespace engine
