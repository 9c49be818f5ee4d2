/// Step 6 of the loop: collision detection, which makes the temporary constraints of the next step
/// and hands every point that is found again the impulses it had (contact caching).
#pragma once
#include <vector>

#include "engine/base/workers.h"
#include "engine/collision/broad_phase.h"
#include "engine/collision/moving_contacts.h"
#include "engine/collision/seams.h"
#include "engine/collision/sensors.h"
#include "engine/constraints/contact.h"

namespace engine {

struct ContactFinder {
    BroadPhase broadPhase;
    std::vector<PairKey> jointed;    // sorted: bodies held by a joint do not collide
    MovingPairs moving;              // those that the margin is too short for
    std::vector<Contact> contacts;   // sorted by pair; fast ones may have two
    std::vector<Contact> previous;   // kept for its memory only
    std::vector<std::vector<Contact>> found;  // of every thread
    Workers* workers = nullptr;      // share the pairs; nobody: the caller looks at all of them
    Seams seams;                     // of floors of several bodies
    std::vector<Contact> asleep;     // sorted: of sleeping islands (sleeping_contacts.h)
    std::vector<Sensed> sensed;      // sorted: of sensors, now
};

inline PairKey pairOf(const Contact& contact) { return {contact.a, contact.b}; }

/// `margin` (m): contacts are made this far ahead of touching. A pair that would cover more than
/// that within dt (s) gets them where it will touch (moving_contacts.h). Pairs that sleep are not
/// looked at.
void findContacts(const Bodies& bodies, ContactFinder& finder, double margin, double dt);

/// Impulses from one contact of a pair to the next: by feature, or else by place.
void carryImpulses(const Contact& from, Contact& to);

}  // namespace engine
