#include "demos/regression/loads.h"

#include <algorithm>

namespace demos {
namespace {

constexpr std::size_t kWindow = 16;   // moments
constexpr double kWeightShare = 0.1;  // of a body's weight, for loads that are nearly nothing

/// By body and moment: the sum of its impulses from the start, N s. `rounding`: what each costs.
struct LoadSums {
    std::vector<std::vector<double>> sums, rounding;

    LoadSums(const Trajectory& trajectory, std::size_t moments)
        : sums(trajectory.bodies.size(), std::vector<double>(moments + 1, 0.0)), rounding(sums) {
        for (std::size_t k = 0; k < moments; ++k) {
            for (std::size_t body = 0; body < sums.size(); ++body) {
                sums[body][k + 1] = sums[body][k];
                rounding[body][k + 1] = rounding[body][k];
            }
            for (const TrajectoryImpulse& impulse : trajectory.moments[k].impulses)
                for (const int body : trajectory.ends[impulse.constraint])
                    if (body >= 0) {
                        sums[body][k + 1] += impulse.value;
                        rounding[body][k + 1] += trajectory.resolution.impulse / 2;
                    }
        }
    }
};

/// The number of moments at the start that both have, before the given step.
std::size_t commonMoments(const Trajectory& a, const Trajectory& b, int steps) {
    const std::size_t most = std::min(a.moments.size(), b.moments.size());
    std::size_t count = 0;
    while (count < most && a.moments[count].step == b.moments[count].step &&
           a.moments[count].step < steps)
        ++count;
    return count;
}

class LoadComparison {
public:
    LoadComparison(const Trajectory& baseline, const Trajectory& actual, std::size_t moments,
                   double share)
        : trajectory_(baseline),
          baseline_(baseline, moments),
          actual_(actual, moments),
          share_(share) {}

    /// From moment `begin` to before `end`, with a moment on each side.
    LoadChange change(int body, int place, std::size_t begin, std::size_t end) const {
        const std::vector<double>& was = baseline_.sums[body];
        const std::vector<double>& is = actual_.sums[place];
        const int first = trajectory_.moments[begin - 1].step + 1;
        const int last = trajectory_.moments[end - 1].step;
        const double seconds = static_cast<double>(last - first + 1) / trajectory_.hz;
        const double sum = is[end] - is[begin];
        const double most = was[end + 1] - was[begin - 1], least = was[end - 1] - was[begin + 1];
        const double floor =
            kWeightShare * trajectory_.masses[body] * trajectory_.gravity * seconds +
            baseline_.rounding[body][end + 1] - baseline_.rounding[body][begin - 1];
        const double over = sum > most    ? (sum - most) / (share_ * most + floor)
                            : sum < least ? (least - sum) / (share_ * least + floor)
                                          : 0.0;
        return {body, first, last, (was[end] - was[begin]) / seconds, sum / seconds, over};
    }

private:
    const Trajectory& trajectory_;
    LoadSums baseline_, actual_;
    double share_;
};

}  // namespace

std::optional<LoadChange> changedLoad(const Trajectory& baseline, const Trajectory& actual,
                                      const std::vector<int>& places, int steps, double share) {
    const std::size_t moments = commonMoments(baseline, actual, steps);
    if (moments < 4 || baseline.masses.empty() || actual.masses.empty()) return std::nullopt;
    const LoadComparison loads(baseline, actual, moments, share);
    const std::size_t window = std::min(kWindow, moments - 3);
    // Before the first moment and after the last nothing is known.
    for (std::size_t begin = 1; begin + window < moments; begin += std::max(window / 2, 1ul)) {
        LoadChange worst;
        for (std::size_t body = 0; body < places.size(); ++body) {
            if (places[body] < 0 || !(baseline.masses[body] > 0.0)) continue;
            const LoadChange own =
                loads.change(static_cast<int>(body), places[body], begin, begin + window);
            if (own.used > worst.used) worst = own;
        }
        if (worst.used > 1.0) return worst;
    }
    return std::nullopt;
}

}  // namespace demos
