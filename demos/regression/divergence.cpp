#include "demos/regression/divergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "demos/regression/loads.h"
#include "demos/regression/trajectory_codec.h"
#include "demos/text/complaints.h"

namespace demos {
namespace {

constexpr double kDegrees = 57.29577951308232;
constexpr int kNone = -1;

/// How far a body is from its baseline at one moment.
struct Apart {
    double used = 0.0;  // share of its tolerance; 1: all of it
    int body = kNone;   // index in the baseline
    const char* field = "";
    double difference = 0.0;  // m or deg
};

/// The angle is 2 |vector part of a^-1 b| while it is small; an arccosine would be noisy there.
double turnBetween(const Quat& a, const Quat& b) {
    const Quat turn = a.conjugate() * b;
    return 2.0 * std::atan2(turn.vec().norm(), std::abs(turn.w())) * kDegrees;
}

Apart apart(const engine::Pose& baseline, const engine::Pose& actual, const Tolerance& tolerance) {
    static constexpr const char* kAxes[] = {"x", "y", "z"};
    Apart worst;
    for (int i = 0; i < 3; ++i) {
        const double difference = actual.position[i] - baseline.position[i];
        const double used = std::abs(difference) / tolerance.position;
        if (used > worst.used) worst = {used, kNone, kAxes[i], difference};
    }
    const double turn = turnBetween(baseline.rotation, actual.rotation);
    if (turn / tolerance.angleDegrees > worst.used)
        worst = {turn / tolerance.angleDegrees, kNone, "turn", turn};
    return worst;
}

/// The index in `names` of each of `wanted`; -1: missing.
std::vector<int> placesOf(const std::vector<std::string>& wanted,
                          const std::vector<std::string>& names) {
    std::map<std::string, int> known;
    for (std::size_t i = 0; i < names.size(); ++i) known.emplace(names[i], static_cast<int>(i));
    std::vector<int> places;
    for (const std::string& name : wanted) {
        const auto found = known.find(name);
        places.push_back(found == known.end() ? kNone : found->second);
    }
    return places;
}

int firstDifferent(const Trajectory& a, const Trajectory& b) {
    const auto [in, unused] = std::mismatch(
        a.hashes.begin(), a.hashes.begin() + std::min(a.hashes.size(), b.hashes.size()),
        b.hashes.begin());
    const auto at = static_cast<std::size_t>(in - a.hashes.begin());
    return at == std::min(a.hashes.size(), b.hashes.size()) ? kNone : static_cast<int>(at);
}

std::map<std::string, double> impulsesOf(const Trajectory& trajectory,
                                         const TrajectoryMoment& moment) {
    std::map<std::string, double> impulses;
    for (const TrajectoryImpulse& impulse : moment.impulses)
        impulses[trajectory.constraints[impulse.constraint]] = impulse.value;
    return impulses;
}

std::string lengthText(double meters) {
    return std::abs(meters) < 1.0 ? fmt::format("{:.3g} mm", 1e3 * meters)
                                  : fmt::format("{:.4g} m", meters);
}

std::string fieldDifference(const std::string& field, double difference) {
    return field == "turn" ? fmt::format("{:.3g} deg", difference) : lengthText(difference);
}

const char* unitOf(const std::string& constraint) {
    return constraint.starts_with(kTorquePrefix) ? "N m" : "N";
}

class Comparison {
public:
    Comparison(const Trajectory& baseline, const Trajectory& actual, const Tolerance& tolerance)
        : baseline_(baseline),
          actual_(actual),
          tolerance_(tolerance),
          places_(placesOf(baseline.bodies, actual.bodies)) {
        // What a baseline with wide tolerances keeps of a pose is rounded.
        const TrajectoryResolution& kept = baseline.resolution;
        inPlace_.position = std::max(inPlace_.position, kept.position);
        inPlace_.angleDegrees = std::max(inPlace_.angleDegrees, 4.0 * kDegrees * kept.rotation);
    }

    PhysicsVerdict verdict() {
        result_.firstBits = firstDifferent(baseline_, actual_);
        compareBodies();
        if (result_.firstBits != kNone) compareMoments();
        if (result_.kind != PhysicsVerdict::Kind::changed) compareLoads();
        tellMasses();
        if (result_.kind != PhysicsVerdict::Kind::changed)
            result_.kind = result_.firstBits == kNone ? PhysicsVerdict::Kind::same
                                                      : PhysicsVerdict::Kind::bits;
        if (result_.kind == PhysicsVerdict::Kind::bits) tellBits();
        return std::move(result_);
    }

private:
    void compareBodies() {
        const auto tell = [this](const std::vector<std::string>& names,
                                 const std::vector<int>& places, const char* what) {
            const auto missing = std::count(places.begin(), places.end(), kNone);
            const auto first = std::find(places.begin(), places.end(), kNone);
            if (missing == 0) return;
            result_.kind = PhysicsVerdict::Kind::changed;
            result_.lines.push_back(
                fmt::format("body {} is {}{}", printable(names[first - places.begin()]), what,
                            missing > 1 ? fmt::format(", and {} others", missing - 1) : ""));
        };
        tell(baseline_.bodies, places_, "gone");
        tell(actual_.bodies, placesOf(actual_.bodies, baseline_.bodies), "new");
    }

    void compareMoments() {
        auto actual = actual_.moments.begin();
        Apart farthest;
        int farthestStep = kNone, before = 0;
        for (const TrajectoryMoment& moment : baseline_.moments) {
            while (actual != actual_.moments.end() && actual->step < moment.step) ++actual;
            if (actual == actual_.moments.end()) break;
            if (actual->step != moment.step) continue;
            const Apart worst = worstOf(moment, *actual, tolerance_);
            if (apartFrom_ == Trajectory::kAll && worstOf(moment, *actual, inPlace_).used > 1.0)
                apartFrom_ = moment.step;
            if (result_.step == kNone) result_.every = moment.step - before;
            if (worst.used > 1.0 && result_.step == kNone) tellFirst(worst, moment, *actual);
            before = moment.step;
            if (worst.used > farthest.used) farthest = worst, farthestStep = moment.step;
        }
        result_.used = farthest.used;
        if (result_.step != kNone && farthestStep != result_.step)
            result_.lines.push_back(
                fmt::format("largest: step {} ({}): {} {} differs by {}", farthestStep,
                            timeText(farthestStep), nameOf(farthest), farthest.field,
                            fieldDifference(farthest.field, farthest.difference)));
    }

    /// Only while the bodies are where they were: a pile that falls otherwise has other loads.
    void compareLoads() {
        const std::optional<LoadChange> change =
            changedLoad(baseline_, actual_, places_, apartFrom_, tolerance_.load);
        if (!change) return;
        result_.kind = PhysicsVerdict::Kind::changed;
        result_.step = change->first;
        result_.body = baseline_.bodies[change->body];
        result_.field = "load";
        result_.difference = change->after - change->before;
        result_.used = change->used;
        result_.lines.push_back(fmt::format("step {} ({}): the {} differs: {:.4g} -> {:.4g} {}, mean until step {}",
                                            change->first, timeText(change->first), loadName(*change),
                                            change->before, change->after, unitOf(change->joint), change->last));
    }

    std::string loadName(const LoadChange& change) const {
        if (change.joint.starts_with(kTorquePrefix)) return printable(change.joint);
        return "load of " + printable(change.joint.empty() ? result_.body : change.joint);
    }

    void tellMasses() {
        std::vector<std::string> texts;
        for (std::size_t i = 0; i < baseline_.masses.size(); ++i) {
            if (places_[i] == kNone || actual_.masses.empty()) continue;
            const double was = baseline_.masses[i], is = actual_.masses[places_[i]];
            if (std::abs(is - was) > 1e-9 * was)
                texts.push_back(fmt::format("the mass of {} differs: {:.6g} -> {:.6g} kg",
                                            printable(baseline_.bodies[i]), was, is));
        }
        if (texts.empty()) return;
        const std::string more =
            texts.size() > 1 ? fmt::format(" (and {} more)", texts.size() - 1) : "";
        result_.lines.push_back(texts.front() + more);
    }

    Apart worstOf(const TrajectoryMoment& baseline, const TrajectoryMoment& actual,
                  const Tolerance& tolerance) const {
        Apart worst;
        for (std::size_t i = 0; i < baseline.poses.size(); ++i) {
            if (places_[i] == kNone) continue;
            Apart own = apart(baseline.poses[i], actual.poses[places_[i]], tolerance);
            own.body = static_cast<int>(i);
            if (own.used > worst.used) worst = own;
        }
        return worst;
    }

    void tellFirst(const Apart& worst, const TrajectoryMoment& baseline,
                   const TrajectoryMoment& actual) {
        result_.kind = PhysicsVerdict::Kind::changed;
        result_.step = baseline.step;
        result_.body = baseline_.bodies[worst.body];
        result_.field = worst.field;
        result_.difference = worst.difference;
        findConstraint(baseline, actual);
        std::string line =
            fmt::format("step {} ({}): {} {} differs by {}", result_.step, timeText(result_.step),
                        nameOf(worst), worst.field, fieldDifference(worst.field, worst.difference));
        if (!result_.constraint.empty())
            line += fmt::format("; {} lambda {:.4g} -> {:.4g} {} s", printable(result_.constraint),
                                result_.before, result_.after, unitOf(result_.constraint));
        result_.lines.push_back(line);
        tellBegin();
    }

    /// The difference begins before the tolerance is reached, and between two recorded steps.
    void tellBegin() {
        if (result_.firstBits < result_.step)
            result_.lines.push_back(fmt::format("the bits differ from step {} on ({})",
                                                result_.firstBits, timeText(result_.firstBits)));
        if (result_.every > 1)
            result_.lines.push_back(
                fmt::format("the baseline keeps one step in {} here, so the "
                            "difference may begin up to {} steps earlier",
                            result_.every, result_.every - 1));
    }

    /// Finds the constraint whose impulse differs most in this step.
    void findConstraint(const TrajectoryMoment& baseline, const TrajectoryMoment& actual) {
        std::map<std::string, double> before = impulsesOf(baseline_, baseline);
        std::map<std::string, double> after = impulsesOf(actual_, actual);
        for (const auto& [name, value] : before) after.emplace(name, 0.0);
        double most = 2.0 * (baseline_.resolution.impulse + actual_.resolution.impulse);
        for (const auto& [name, value] : after) {
            const double was = before[name];
            if (std::abs(value - was) <= most) continue;
            most = std::abs(value - was);
            result_.constraint = name;
            result_.before = was;
            result_.after = value;
        }
    }

    void tellBits() {
        result_.lines.push_back(fmt::format(
            "the bits differ from step {} on ({}), within the tolerances of {} and "
            "{:.3g} deg: {:.2g} % of them used",
            result_.firstBits, timeText(result_.firstBits), lengthText(tolerance_.position),
            tolerance_.angleDegrees, 100.0 * result_.used));
    }

    std::string nameOf(const Apart& worst) const { return printable(baseline_.bodies[worst.body]); }
    std::string timeText(int step) const { return fmt::format("{:.4g} s", baseline_.timeOf(step)); }

    const Trajectory& baseline_;
    const Trajectory& actual_;
    const Tolerance& tolerance_;
    Tolerance inPlace_;        // the default one
    int apartFrom_ = Trajectory::kAll;  // first step in which a pose is beyond it
    std::vector<int> places_;  // index in the actual run of each of the baseline's bodies
    PhysicsVerdict result_;
};

}  // namespace

PhysicsVerdict diverge(const Trajectory& baseline, const Trajectory& actual,
                       const Tolerance& tolerance) {
    // A moment has the impulses since the one before, so both runs need the same moments.
    const int dense = std::min(baseline.dense, actual.dense);
    if (actual.dense != dense)
        return Comparison(baseline, thinned(actual, dense), tolerance).verdict();
    if (baseline.dense != dense)
        return Comparison(thinned(baseline, dense), actual, tolerance).verdict();
    return Comparison(baseline, actual, tolerance).verdict();
}

}  // namespace demos
