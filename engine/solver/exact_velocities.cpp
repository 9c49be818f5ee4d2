#include "engine/solver/exact_velocities.h"

#include "engine/solver/direct.h"

namespace engine {

ExactVelocities::ExactVelocities(const Constraints& c, std::span<const Velocity> v,
                                 const Settings& settings, double h) {
    if (!settings.compareExact) return;
    GlobalRows g = globalRows(c, v, settings, h);
    const std::optional<DirectReport> report = solveDirect(g, c, static_cast<int>(v.size()));
    if (!report || !report->found) return;
    exact_.assign(v.begin(), v.end());
    for (double& force : g.force) force *= h;
    addAlongRows(g, g.force, exact_);
}

double ExactVelocities::distance(std::span<const Velocity> v) const {
    if (exact_.empty()) return -1.0;
    double most = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i) {
        most = larger(most, (v[i].linear - exact_[i].linear).cwiseAbs().maxCoeff());
        most = larger(most, (v[i].angular - exact_[i].angular).cwiseAbs().maxCoeff());
    }
    return most;
}

}  // namespace engine
