#include "engine/solver/exact_velocities.h"

#include <type_traits>

#include "engine/solver/direct.h"

namespace engine {

template <class Real>
ExactVelocities<Real>::ExactVelocities(const Constraints<Real>& c,
                                       std::span<const Velocity<Real>> v, const Settings& settings,
                                       Real h) {
    if constexpr (std::is_same_v<Real, double>) {
        if (!settings.compareExact) return;
        GlobalRows<double> g = globalRows<double>(c, v, settings, h);
        const std::optional<DirectReport> report = solveDirect(g, c, static_cast<int>(v.size()));
        if (!report || !report->found) return;
        exact_.assign(v.begin(), v.end());
        for (double& force : g.force) force *= h;
        addAlongRows<double>(g, g.force, exact_);
    }
}

template <class Real>
double ExactVelocities<Real>::distance(std::span<const Velocity<Real>> v) const {
    if (exact_.empty()) return -1.0;
    Real most = Real(0);
    for (std::size_t i = 0; i < v.size(); ++i) {
        most = larger(most, (v[i].linear - exact_[i].linear).cwiseAbs().maxCoeff());
        most = larger(most, (v[i].angular - exact_[i].angular).cwiseAbs().maxCoeff());
    }
    return static_cast<double>(most);
}

template class ExactVelocities<float>;
template class ExactVelocities<double>;

}  // namespace engine
