#include "demos/regression/loads.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>

namespace demos {
namespace {

constexpr std::size_t kWindow = 16;   // moments
constexpr double kWeightShare = 0.1;  // of a body's weight, for loads that are nearly nothing
constexpr double kShareOfJoint = 1e-3;

/// A force or torque of a joint that acts in both runs.
struct SharedJoint {
    int before = -1, after = -1;  // index in Trajectory::constraints
    int body = -1;                // its lighter body, index in the baseline
    double arm = 1.0;             // m, of a torque: half the diagonal of that body's box
};

bool isTorque(const std::string& constraint) { return constraint.starts_with(kTorquePrefix); }

/// The lighter one with a mass; -1: none has.
int lighterEnd(const Trajectory& trajectory, const std::array<int, 2>& ends) {
    int lighter = -1;
    for (const int end : ends)
        if (end >= 0 && trajectory.masses[end] > 0.0 &&
            (lighter < 0 || trajectory.masses[end] < trajectory.masses[lighter]))
            lighter = end;
    return lighter;
}

std::vector<SharedJoint> sharedJoints(const Trajectory& baseline, const Trajectory& actual) {
    std::map<std::string, int> known;
    for (std::size_t i = 0; i < actual.constraints.size(); ++i)
        known.emplace(actual.constraints[i], static_cast<int>(i));
    std::vector<SharedJoint> joints;
    for (std::size_t i = 0; i < baseline.constraints.size(); ++i) {
        const auto found = known.find(baseline.constraints[i]);
        const int body = lighterEnd(baseline, baseline.ends[i]);
        const bool torque = isTorque(baseline.constraints[i]);
        if (found == known.end() || body < 0 || !(torque || baseline.constraints[i].starts_with(kJointPrefix)))
            continue;
        joints.push_back({static_cast<int>(i), found->second, body, torque ? baseline.extents[body].norm() : 1.0});
    }
    return joints;
}

/// By body and moment, then by constraint and moment: the sum of the impulses from the start, N s. `rounding`: what
/// each costs.
struct LoadSums {
    std::vector<std::vector<double>> sums, rounding;

    LoadSums(const Trajectory& trajectory, std::size_t moments)
        : sums(trajectory.bodies.size() + trajectory.constraints.size(),
               std::vector<double>(moments + 1, 0.0)),
          rounding(sums), bodies_(trajectory.bodies.size()) {
        for (std::size_t k = 0; k < moments; ++k) {
            for (std::size_t i = 0; i < sums.size(); ++i) {
                sums[i][k + 1] = sums[i][k];
                rounding[i][k + 1] = rounding[i][k];
            }
            for (const TrajectoryImpulse& impulse : trajectory.moments[k].impulses) {
                add(ofConstraint(impulse.constraint), k, impulse.value, trajectory);
                if (isTorque(trajectory.constraints[impulse.constraint])) continue;
                for (const int body : trajectory.ends[impulse.constraint])
                    if (body >= 0) add(body, k, impulse.value, trajectory);
            }
        }
    }
    std::size_t ofConstraint(int constraint) const { return bodies_ + constraint; }

private:
    void add(std::size_t i, std::size_t k, double value, const Trajectory& trajectory) {
        sums[i][k + 1] += value;
        rounding[i][k + 1] += trajectory.resolution.impulse / 2;
    }
    std::size_t bodies_;
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

    /// Of a body, from moment `begin` to before `end`, with a moment on each side. `place`: in the actual run.
    LoadChange change(int body, int place, std::size_t begin, std::size_t end) const {
        return change(body, kWeightShare, body, place, begin, end);
    }
    LoadChange change(const SharedJoint& joint, std::size_t begin, std::size_t end) const {
        LoadChange own = change(joint.body, kShareOfJoint * joint.arm, baseline_.ofConstraint(joint.before),
                                actual_.ofConstraint(joint.after), begin, end);
        own.joint = trajectory_.constraints[joint.before];
        return own;
    }

private:
    /// `body`: whose weight counts, `shareOfWeight` of it (m for a torque); `before`, `after`: of which sums.
    LoadChange change(int body, double shareOfWeight, std::size_t before, std::size_t after, std::size_t begin,
                      std::size_t end) const {
        const std::vector<double>& was = baseline_.sums[before];
        const std::vector<double>& is = actual_.sums[after];
        const int first = trajectory_.moments[begin - 1].step + 1;
        const int last = trajectory_.moments[end - 1].step;
        const double seconds = static_cast<double>(last - first + 1) / trajectory_.hz;
        const double sum = is[end] - is[begin];
        const double most = was[end + 1] - was[begin - 1], least = was[end - 1] - was[begin + 1];
        const double floor = shareOfWeight * trajectory_.masses[body] * trajectory_.gravity * seconds;
        const double rounding = baseline_.rounding[before][end + 1] - baseline_.rounding[before][begin - 1];
        const auto allowed = [&](double load) { return std::max(share_ * load, floor) + rounding; };
        const double beyond = sum > most ? sum - most : sum < least ? least - sum : 0.0;
        const double used = beyond > 0.0 ? beyond / allowed(sum > most ? most : least) : 0.0;
        return {body, {}, first, last, (was[end] - was[begin]) / seconds, sum / seconds, used};
    }

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
    const std::vector<SharedJoint> joints = sharedJoints(baseline, actual);
    const std::size_t window = std::min(kWindow, moments - 3);
    // Before the first moment and after the last nothing is known.
    const std::size_t last = moments - 1 - window;
    for (std::size_t begin = 1;; begin = std::min(begin + std::max(window / 2, 1ul), last)) {
        LoadChange worst;
        const auto look = [&worst](const LoadChange& own) {
            if (own.used > worst.used) worst = own;
        };
        for (std::size_t body = 0; body < places.size(); ++body)
            if (places[body] >= 0 && baseline.masses[body] > 0.0)
                look(loads.change(static_cast<int>(body), places[body], begin, begin + window));
        for (const SharedJoint& joint : joints) look(loads.change(joint, begin, begin + window));
        if (worst.used > 1.0) return worst;
        if (begin == last) return std::nullopt;
    }
}

}  // namespace demos
