/// What the sweeps are after: the velocities of the direct solution (Settings::compareExact).
#pragma once
#include "engine/solver/constraints.h"

namespace engine {

template <class Real>
class ExactVelocities {
public:
    /// From the velocities before solving. Unknown (distance -1) unless the settings ask for it, in
    /// float, and for more rows than the direct solver takes.
    ExactVelocities(const Constraints<Real>& c, std::span<const Velocity<Real>> v,
                    const Settings& settings, Real h);

    /// The largest difference of any velocity, m/s (rad/s).
    double distance(std::span<const Velocity<Real>> v) const;

private:
    std::vector<Velocity<Real>> exact_;  // empty: not known
};

extern template class ExactVelocities<float>;
extern template class ExactVelocities<double>;

}  // namespace engine
