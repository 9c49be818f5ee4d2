/// Islands that fall asleep. Bodies that touch or are jointed are an island; it rests as a whole or
/// not at all.
///   slow     |v| + |w| r < 3 cm/s, r being how far the body reaches from its centre of mass
///   asleep   every body of the island has been slow for Settings::sleepAfter seconds on end, and
///            no kinematic body that moves touches or holds one of them
/// Asleep its velocities are zero and steps leave it alone. A lower speed would keep large piles
/// awake, which tremble at rest (a pyramid of 820 boxes by 1 cm/s). A pendulum of 1 m is slow for a
/// quarter of its period, half a second, only if it swings by less than 14 mm. What drifts that
/// slowly is stopped.
#pragma once
#include <vector>

#include "engine/base/disjoint_sets.h"
#include "engine/dynamics/bodies.h"

namespace engine {

/// Who is asleep is told by Bodies::asleep; here is who becomes so, and who was called to wake.
/// Calls are kept until the next step begins: nothing changes while a step is under way.
class Sleep {
public:
    /// A new body, perhaps in the slot of one that was removed, is not tired.
    void add(const Bodies& bodies, int body);

    /// Counts a step of dt (s) for all who are slow. True: some have been for `after` (s).
    bool anyoneTired(const Bodies& bodies, double after, double dt);
    /// Then every pair that touches or is jointed,
    void connect(const Bodies& bodies, int a, int b);
    /// and those islands fall asleep of which all are tired. True: there is one.
    bool fallAsleep(Bodies& bodies, double after);

    /// The body's island is to wake, or to stay awake.
    void call(const Bodies& bodies, int body);
    void callAll(const Bodies& bodies);
    /// Asleep, and not called.
    bool staysAsleep(const Bodies& bodies, int body) const {
        return bodies.isAsleep(body) && !called_[bodies.asleep[body]];
    }
    /// Wakes the islands that were called. True: there was one.
    bool wakeCalled(Bodies& bodies);

    int count() const { return count_; }  // of the bodies asleep

private:
    void fit(const Bodies& bodies);

    std::vector<double> slowFor_;  // s, by body
    std::vector<char> called_;     // by the least body of an island
    std::vector<char> restless_;   // likewise
    DisjointSets islands_;
    bool anyCalled_ = false;
    int count_ = 0;
};

}  // namespace engine
