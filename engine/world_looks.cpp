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

/// Marks the islands that these bodies may reach, and those reached from there by thrown bodies.
class Reached {
public:
    Reached(WorldState& s, double dt) : s_(s), dt_(dt), islands_(s.bodies.count(), 0) {}

    void add(std::vector<int> bodies) {
        for (const int i : bodies) mark(i);
        std::vector<int> waiting = s_.finder.moving.thrown;
        while (!bodies.empty()) {
            std::ranges::for_each(bodies, [&](int i) { spread(i); });
            const auto rest = std::partition(waiting.begin(), waiting.end(), [&](int i) { return !has(i); });
            bodies.assign(rest, waiting.end());
            waiting.erase(rest, waiting.end());
        }
    }
    bool has(int body) { return s_.bodies.isAwake(body) && islands_[s_.solver.islands.leaderOf(body)]; }

private:
    void mark(int body) {
        if (s_.bodies.isAwake(body)) islands_[s_.solver.islands.leaderOf(body)] = 1;
    }
    void spread(int body) {
        if (!s_.bodies.isAwake(body)) return;
        s_.finder.broadPhase.tree().query(reachOf(s_, body, dt_), open_, [&](int other) { mark(other); });
    }

    WorldState& s_;
    double dt_;
    std::vector<char> islands_;  // by leader
    std::vector<int> open_;
};

/// Dynamic bodies; the others need not look, because all that they may hit does.
void setLooks(WorldState& s, Reached& reached, std::vector<char>& looks) {
    looks.assign(s.bodies.count(), 0);
    for (const int i : s.bodies.active) looks[i] = reached.has(i);
}

}  // namespace

int chooseLooks(WorldState& s, double dt) {
    s.fast.clear();
    const int count = looksNeeded(s.finder.moving, s.bodies, dt, s.fast);
    Reached reached(s, dt);
    if (count > 1) reached.add(s.fast);
    setLooks(s, reached, s.looks);
    s.lookedAt.assign(s.bodies.count(), 0);
    return count;
}

bool looksAgain(WorldState& s, int substep, double h) {
    s.turned.clear();
    if (substep == 0) return false;
    findWhoTurnsFar(s.finder.contacts, s.bodies, s.lookedAt, substep, h, s.turned);
    return substep % s.substepsALook == 0 || !s.turned.empty();
}

void findContactsWithin(WorldState& s, int substep, double h) {
    Reached reached(s, (s.report.substeps - substep) * h);
    reached.add(s.turned);
    setLooks(s, reached, s.looksNow);
    const bool all = substep % s.substepsALook == 0;
    for (const int i : s.bodies.active)  // who does not look keeps its contacts, like one that waits
        s.bodies.acts[i] = s.bodies.acts[i] && (s.looksNow[i] || (all && s.looks[i]) || !s.bodies.isAwake(i));
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
