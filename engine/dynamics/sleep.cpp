#include "engine/dynamics/sleep.h"

#include <algorithm>

namespace engine {
namespace {

constexpr double kSlow = 0.03;  // m/s, of any of a body's points

bool isSlow(const Bodies& bodies, int i) {
    const Velocity& v = bodies.velocities[i];
    return v.linear.norm() + v.angular.norm() * reachOf(bodies.defs[i].shape) < kSlow;
}

}  // namespace

void Sleep::fit(const Bodies& bodies) {
    slowFor_.resize(bodies.count());
    called_.resize(bodies.count());
}

void Sleep::add(const Bodies& bodies, int body) {
    fit(bodies);
    slowFor_[body] = 0.0;
}

bool Sleep::anyoneTired(const Bodies& bodies, double after, double dt) {
    fit(bodies);
    bool tired = false;
    for (const int i : bodies.active) {
        if (!bodies.isAwake(i)) continue;
        slowFor_[i] = isSlow(bodies, i) ? slowFor_[i] + dt : 0.0;
        tired = tired || slowFor_[i] >= after;
    }
    if (tired) islands_.reset(bodies.count(), bodies.active);
    return tired;
}

void Sleep::connect(const Bodies& bodies, int a, int b) {
    if (bodies.isAwake(a) && bodies.isAwake(b))
        islands_.join(a, b);
    else if (bodies.isDriven(a) || bodies.isDriven(b))
        slowFor_[bodies.isDynamic(a) ? a : b] = 0.0;
}

bool Sleep::fallAsleep(Bodies& bodies, double after) {
    restless_.assign(bodies.count(), 0);
    for (const int i : bodies.active)
        if (bodies.isAwake(i) && slowFor_[i] < after) restless_[islands_.leaderOf(i)] = 1;
    const int before = count_;
    for (const int i : bodies.active) {
        if (!bodies.isAwake(i) || restless_[islands_.leaderOf(i)]) continue;
        bodies.asleep[i] = islands_.leaderOf(i);
        bodies.velocities[i] = {};
        ++count_;
    }
    bodies.activeShrinks = bodies.activeShrinks || count_ > before;
    return count_ > before;
}

void Sleep::call(const Bodies& bodies, int body) {
    fit(bodies);
    slowFor_[body] = 0.0;
    if (!bodies.isAsleep(body)) return;
    called_[bodies.asleep[body]] = 1;
    anyCalled_ = true;
}

void Sleep::callAll(const Bodies& bodies) {
    for (int i = 0; i < bodies.count(); ++i) call(bodies, i);
}

bool Sleep::wakeCalled(Bodies& bodies) {
    if (!anyCalled_) return false;
    for (int i = 0; i < bodies.count(); ++i) {
        if (!bodies.isAsleep(i) || !called_[bodies.asleep[i]]) continue;
        bodies.asleep[i] = -1;
        activate(bodies, i);
        slowFor_[i] = 0.0;
        --count_;
    }
    std::fill(called_.begin(), called_.end(), char{0});
    anyCalled_ = false;
    return true;
}

}  // namespace engine
