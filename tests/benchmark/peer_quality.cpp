#include "tests/benchmark/peer_quality.h"

#include <algorithm>
#include <cmath>

#include "tests/benchmark/peer_clock.h"
#include "tests/benchmark/peer_text.h"

namespace peers {

namespace {

constexpr double kFallen = 0.5;  // m from the start

class Watcher {
public:
    Watcher(const Scene& scene, const Engine& engine)
        : scene_(scene), engine_(engine), check_(scene), states_(scene.bodies.size()) {
        readStates();
        energyAtStart_ = energy(scene, states_);
        momentumAtStart_ = angularMomentum(scene, states_);
    }

    void see(int step);
    Quality finish();
    bool isFinite() const { return finite(states_); }
    void giveUp(int step) { quality_.gaveUpTime = step * scene_.step; }

private:
    void readStates() {
        for (std::size_t i = 0; i < states_.size(); ++i)
            states_[i] = engine_.state(static_cast<int>(i));
    }
    void seeFall();
    void seeEnergy();
    void seeMomentum();
    void seeSeparation();
    void seeContacts();

    const Scene& scene_;
    const Engine& engine_;
    PenetrationCheck check_;
    std::vector<BodyState> states_;
    double energyAtStart_ = 0.0, sumOfSquares_ = 0.0;
    Vec3 momentumAtStart_;
    int contactsSeen_ = -1;  // at this step
    Quality quality_;
};

void Watcher::see(int step) {
    readStates();
    quality_.steps = step;
    if (!isFinite()) return;
    if (scene_.shouldStand && quality_.fallTime < 0.0) seeFall();
    if (scene_.watchEnergy) seeEnergy();
    if (scene_.watchMomentum) seeMomentum();
    if (!scene_.joints.empty()) seeSeparation();
    if (step % 10 == 0 || step < 30) seeContacts();  // the check costs more than most steps
}

void Watcher::seeFall() {
    if (drift(scene_, states_).total > kFallen) quality_.fallTime = quality_.steps * scene_.step;
}

void Watcher::seeEnergy() {
    quality_.energyEnd = (energy(scene_, states_) - energyAtStart_) / scene_.energyScale;
    quality_.energyLow = std::min(quality_.energyLow, quality_.energyEnd);
    quality_.energyHigh = std::max(quality_.energyHigh, quality_.energyEnd);
}

void Watcher::seeMomentum() {
    const Vec3 &before = momentumAtStart_, now = angularMomentum(scene_, states_);
    const double error = std::abs(now.norm() / before.norm() - 1.0);
    const double angle = std::atan2(now.cross(before).norm(), now.dot(before));
    quality_.momentumError = std::max(quality_.momentumError, error);
    quality_.momentumAngle = std::max(quality_.momentumAngle, angle);
}

void Watcher::seeSeparation() {
    quality_.separation = separation(scene_, states_);
    sumOfSquares_ += quality_.separation.meanSquare;
    quality_.rmsSeparation = std::sqrt(sumOfSquares_ / quality_.steps);
    quality_.worstSeparation = std::max(quality_.worstSeparation, quality_.separation.worst);
    quality_.worstAxisAngle = std::max(quality_.worstAxisAngle, quality_.separation.axisAngle);
}

void Watcher::seeContacts() {
    contactsSeen_ = quality_.steps;
    quality_.points = engine_.contactPoints();
    quality_.mostPoints = std::max(quality_.mostPoints, quality_.points);
    if (!scene_.watchPenetration) return;
    quality_.penetration = check_.measure(states_);
    quality_.worstPenetration = std::max(quality_.worstPenetration, quality_.penetration.worst);
}

Quality Watcher::finish() {
    quality_.hash = hash(states_);
    if (!isFinite()) return quality_;
    if (contactsSeen_ != quality_.steps) seeContacts();
    quality_.drift = drift(scene_, states_);
    quality_.fastest = fastest(scene_, states_);
    quality_.lost = lostBodies(scene_, states_);
    quality_.sunk = sunk(scene_, states_);
    return quality_;
}

std::string length(double metres) {
    return metres < 1.0 ? text("%.3g mm", 1e3 * metres) : text("%.3g m", metres);
}

std::string percent(double share) { return text("%+.2g %%", 100.0 * share); }

std::vector<std::string> ofStanding(const Scene& scene, const Quality& q) {
    std::vector<std::string> parts;
    if (q.gaveUpTime >= 0.0) parts.push_back("gave up at " + text("%.1f s", q.gaveUpTime));
    if (q.fallTime >= 0.0)
        parts.push_back("falls at " + text("%.1f s", q.fallTime));
    else if (scene.shouldStand)
        parts.push_back("stands, drift " + length(q.drift.total));
    if (q.lost > 0) parts.push_back(std::to_string(q.lost) + " lost");
    if (scene.slide > 0.0) {
        const double time = q.steps * scene.step, exact = 0.5 * scene.slide * time * time;
        parts.push_back("slides " + text("%.4g", q.drift.total) + text(" of %.4g m", exact));
    }
    return parts;
}

std::vector<std::string> ofErrors(const Scene& scene, const Quality& q) {
    std::vector<std::string> parts;
    if (!scene.joints.empty()) parts.push_back("joints apart " + length(q.worstSeparation));
    if (scene.ground) parts.push_back("below the ground " + length(q.sunk));
    if (scene.watchEnergy)
        parts.push_back("energy " + percent(q.energyLow) + " to " + percent(q.energyHigh));
    if (scene.watchMomentum)
        parts.push_back("momentum off by " + text("%.2g %%", 100.0 * q.momentumError));
    if (scene.watchPenetration)
        parts.push_back("penetration mean " + length(q.penetration.mean) + ", worst " +
                        length(q.penetration.worst));
    return parts;
}

}  // namespace

Quality watch(const Scene& scene, Engine& engine, double budget) {
    const double end = seconds(Clock::wall) + budget;
    engine.build(scene);
    Watcher watcher(scene, engine);
    for (int step = 1; step <= scene.stepCount() && seconds(Clock::wall) < end; ++step) {
        const bool well = engine.step(scene.step);
        watcher.see(step);
        if (well && watcher.isFinite()) continue;
        watcher.giveUp(step);
        break;
    }
    return watcher.finish();
}

std::string verdict(const Scene& scene, const Quality& quality) {
    std::vector<std::string> parts = ofStanding(scene, quality);
    for (const std::string& part : ofErrors(scene, quality)) parts.push_back(part);
    std::string all;
    for (const std::string& part : parts) all += (all.empty() ? "" : "; ") + part;
    return all;
}

}  // namespace peers
