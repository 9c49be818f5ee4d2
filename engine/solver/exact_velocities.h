/// What the sweeps are after: the velocities of the direct solution (Settings::compareExact).
#pragma once
#include "engine/solver/constraints.h"

namespace engine {

class ExactVelocities {
public:
    /// From the velocities before solving. Unknown (distance -1) unless the settings ask for it,
    /// and for more rows than the direct solver takes.
    ExactVelocities(const Constraints& c, std::span<const Velocity> v, const Settings& settings,
                    double h);

    /// The largest difference of any velocity, m/s (rad/s).
    double distance(std::span<const Velocity> v) const;

private:
    std::vector<Velocity> exact_;  // empty: not known
};

}  // namespace engine
