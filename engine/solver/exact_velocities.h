/// The velocities that the sweeps should converge to: those of the direct solution
/// (Settings::compareExact).
#pragma once
#include "engine/solver/constraints.h"

namespace engine {

class ExactVelocities {
public:
    /// Takes the velocities before solving. Unknown (distance -1) unless Settings::compareExact is
    /// set, and for more rows than the direct solver accepts.
    ExactVelocities(const Constraints& c, std::span<const Velocity> v, const Settings& settings,
                    double h);

    /// The largest difference of any velocity, m/s (rad/s).
    double distance(std::span<const Velocity> v) const;

private:
    std::vector<Velocity> exact_;  // empty: unknown
};

}  // namespace engine
