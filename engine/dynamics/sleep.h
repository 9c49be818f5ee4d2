/// Sleeping islands. Bodies that touch or are joined form an island; it sleeps as a whole or not at
/// all.
///   slow     |v| + |w| r < 3 cm/s, r being how far the body reaches from its centre of mass
///   asleep   every body of the island has been slow for Settings::sleepAfter seconds, and
///            no moving kinematic body touches or holds one of them
/// A sleeping body has zero velocity and steps do not change it. A lower speed would keep large
/// piles awake, which vibrate at rest (a pyramid of 820 boxes by 1 cm/s). A pendulum of 1 m is slow
/// for a quarter of its period, half a second, only if it swings by less than 14 mm. Bodies that
/// drift this slowly are stopped.
#pragma once
#include <vector>

#include "engine/base/disjoint_sets.h"
#include "engine/dynamics/bodies.h"

namespace engine {

/// Bodies::asleep tells which bodies sleep; this class decides which fall asleep and records which
/// were called to wake. Calls take effect when the next step begins: nothing changes during a step.
class Sleep {
public:
    /// Adds a body, perhaps in the slot of a removed one: it is not tired.
    void add(const Bodies& bodies, int body);

    /// Counts a step of dt (s) for all slow bodies. True if some have been slow for `after` (s).
    bool anyoneTired(const Bodies& bodies, double after, double dt);
    /// Then: joins the islands of two bodies that touch or are held by a joint.
    void connect(const Bodies& bodies, int a, int b);
    /// Then: puts the islands to sleep whose bodies are all tired. True if there was one.
    bool fallAsleep(Bodies& bodies, double after);

    /// Calls the body's island to wake, or to stay awake.
    void call(const Bodies& bodies, int body);
    void callAll(const Bodies& bodies);
    /// True when asleep and not called.
    bool staysAsleep(const Bodies& bodies, int body) const {
        return bodies.isAsleep(body) && !called_[bodies.asleep[body]];
    }
    /// Wakes the islands that were called. True if there was one.
    bool wakeCalled(Bodies& bodies);

    int count() const { return count_; }  // number of sleeping bodies

    /// What is kept of it in a state (base/state_bytes.h).
    template <class Bytes>
    void keep(Bytes& bytes, int bodies) {
        bytes.sized(bodies, slowFor_, called_);
        bytes(islands_, anyCalled_, count_);
    }

private:
    void fit(const Bodies& bodies);

    std::vector<double> slowFor_;  // s, by body
    std::vector<char> called_;     // by lowest body number of an island
    std::vector<char> restless_;   // the same
    DisjointSets islands_;
    bool anyCalled_ = false;
    int count_ = 0;
};

}  // namespace engine
