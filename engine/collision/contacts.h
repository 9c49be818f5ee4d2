/// Step 6 of the loop: collision detection. It makes the temporary constraints of the next step and
/// gives every point that is found again its previous impulses (contact caching).
#pragma once
#include <vector>

#include "engine/base/workers.h"
#include "engine/collision/broad_phase.h"
#include "engine/collision/jointed_pairs.h"
#include "engine/collision/moving_contacts.h"
#include "engine/collision/seams.h"
#include "engine/collision/sensors.h"
#include "engine/constraints/contact.h"

namespace engine {

/// With more in one step, no step is done. A body in a heap has about five; 200 000 take 0.7 GB.
inline constexpr std::size_t kMostContacts = 200'000;

struct ContactFinder {
    BroadPhase broadPhase;
    JointedPairs jointed;            // they do not collide
    MovingPairs moving;              // pairs that move farther than the margin
    std::vector<Contact> contacts;   // sorted by pair; fast ones may have two
    std::vector<Contact> previous;   // kept for its memory only
    std::vector<std::vector<Contact>> found;  // by thread
    std::vector<Looked> looked;      // by thread
    Workers* workers = nullptr;      // share the pairs; null: the caller's thread does all
    Seams seams;                     // for floors made of several bodies
    std::vector<Contact> asleep;     // sorted: of sleeping islands (sleeping_contacts.h)
    std::vector<Sensed> sensed;      // sorted: current overlaps of sensors
    bool tooMany = false;            // contacts, or pairs of bodies or pieces: none are listed
};

inline PairKey pairOf(const Contact& contact) { return {contact.a, contact.b}; }

/// `margin` (m): contacts are made this far ahead of touching. A pair that would move farther
/// within dt (s) gets its contacts where it will touch (moving_contacts.h). Sleeping pairs are
/// skipped. Bodies that wait (dynamics/bodies.h) keep their contacts and get no others. Sets `tooMany` whatever
/// the number of threads.
void findContacts(const Bodies& bodies, ContactFinder& finder, double margin, double dt);

/// Copies impulses from a pair's previous contact to its new one, matching points by feature, then
/// by place.
void carryImpulses(const Contact& from, Contact& to);

}  // namespace engine
