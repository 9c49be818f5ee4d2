#include "engine/world_sleep.h"

#include <algorithm>

#include "engine/collision/sleeping_contacts.h"
#include "engine/world_joints.h"

namespace engine {
namespace {

/// Contacts to be solved keep bodies awake: those at rest are in `asleep`.
void wakeTouched(WorldState& s) {
    if (s.sleep.count() == 0) return;
    for (const Contact& contact : s.finder.contacts)
        for (const int body : {contact.a, contact.b})
            if (s.bodies.isAsleep(body)) s.sleep.call(s.bodies, body);
    wakeCalled(s);
}

void fallAsleep(WorldState& s, double dt) {
    const double after = s.settings.sleepAfter;
    if (!s.sleep.anyoneTired(s.bodies, after, dt)) return;
    for (const Contact& contact : s.finder.contacts)
        s.sleep.connect(s.bodies, contact.a, contact.b);
    for (const Joint& joint : s.joints)
        if (joint.present) s.sleep.connect(s.bodies, joint.def.a.index, joint.def.b.index);
    if (!s.sleep.fallAsleep(s.bodies, after)) return;
    layDownContacts(s.bodies, s.finder);
    s.treesStale = true;
}

}  // namespace

void callAround(WorldState& s, int body) {
    s.sleep.call(s.bodies, body);
    if (s.bodies.isDynamic(body)) return;  // all it touches are in its island
    const auto callOther = [&](int a, int b) {
        if (a == body) s.sleep.call(s.bodies, b);
        if (b == body) s.sleep.call(s.bodies, a);
    };
    for (const Contact& contact : s.finder.asleep) callOther(contact.a, contact.b);
    for (const Joint& joint : s.joints)
        if (joint.present) callOther(joint.def.a.index, joint.def.b.index);
}

void callForced(WorldState& s, double dt) {
    if (!s.settings.sleeping) return;
    for (const std::optional<ForceDef>& force : s.forces) {
        if (!force || force->until <= s.report.time || force->from >= s.report.time + dt) continue;
        for (const BodyId id : force->on) s.sleep.call(s.bodies, id.index);
    }
}

void wakeCalled(WorldState& s) {
    if (!s.sleep.wakeCalled(s.bodies)) return;
    takeUpContacts(s.bodies, s.finder);
    s.treesStale = true;
}

void updateSleep(WorldState& s, double dt) {
    wakeTouched(s);
    for (const int i : s.bodies.active) {
        s.bodies.activeShrinks = s.bodies.activeShrinks || (s.bodies.placed[i] && !s.bodies.isMoving(i));
        s.bodies.placed[i] = 0;
    }
    if (!s.settings.sleeping || s.field) return;
    wakeMotors(s);
    fallAsleep(s, dt);
}

}  // namespace engine
