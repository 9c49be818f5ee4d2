#include "engine/solver/riding_contacts.h"

#include "engine/dynamics/rotation.h"

namespace engine {
namespace {

constexpr double kSlowest = 0.01;  // rad/s: slower, a dynamic body carries without a visible creep
constexpr double kMostCarrierTurn = 0.5;  // rad in a sub-step: nothing rides on a faster body

bool turns(const Vec3& spin) { return spin.squaredNorm() > kSlowest * kSlowest; }

/// (R(h w) - 1) rho / h - w x (rho + (h/2) w x rho)
Vec3 restOfChord(const Vec3& w, const Vec3& rho, double h) {
    const Quat turn = turnedBy(h * w, Quat::Identity());
    const Vec3 across = w.cross(rho);
    return (turn * rho - rho) / h - across - 0.5 * h * w.cross(across);
}

}  // namespace

void RidingContacts::markCarriers(std::span<const Joint> joints, const Bodies& bodies) {
    for (const int i : carriers_) carries_[i] = 0;
    carriers_.clear();
    carries_.resize(bodies.count()), rides_.resize(bodies.count());
    const auto mark = [&](int body) {
        if (!carries_[body]) carriers_.push_back(body);
        carries_[body] = 1;
    };
    for (const int i : bodies.active)
        if (bodies.isDriven(i) && !bodies.velocities[i].angular.isZero(0.0)) mark(i);
    for (const Joint& joint : joints) {
        if (!joint.present || joint.def.type != JointType::hinge) continue;
        const int a = joint.def.a.index, b = joint.def.b.index;
        if (bodies.isDynamic(a) == bodies.isDynamic(b)) continue;  // held by nothing else
        const int body = bodies.movable(a, b);
        if (bodies.isAwake(body) && turns(bodies.velocities[body].angular)) mark(body);
    }
}

void RidingContacts::find(std::span<const Contact> contacts, std::span<const Joint> joints,
                          const Bodies& bodies, DisjointSets& islands) {
    list_.clear();
    markCarriers(joints, bodies);
    if (carriers_.empty()) return;
    const auto islandOf = [&](const Contact& c) { return islands.leaderOf(bodies.movable(c.a, c.b)); };
    for (const int i : bodies.active) rides_[i] = 0;
    for (const Contact& c : contacts)
        if (carries_[c.a] || carries_[c.b]) rides_[islandOf(c)] = 1;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const Contact& c = contacts[k];
        if (c.friction <= 0.0 || !rides_[islandOf(c)]) continue;
        RidingContact& riding = list_.emplace_back();
        riding.number = static_cast<int>(k), riding.count = c.count, riding.a = c.a, riding.b = c.b;
        if (carries_[c.a] != carries_[c.b]) riding.carrier = carries_[c.a] ? c.a : c.b;
        Vec3 onA = Vec3::Zero(), onB = Vec3::Zero();
        for (int i = 0; i < c.count; ++i) onA += c.points[i].anchorA, onB += c.points[i].anchorB;
        riding.armA = bodies.poses[c.a].rotation * Vec3(onA / c.count);
        riding.armB = bodies.poses[c.b].rotation * Vec3(onB / c.count);
    }
}

void RidingContacts::begin(const Bodies& bodies, std::span<const Pose> posesAtStart) {
    for (RidingContact& c : list_) {
        c.lead = c.turn = c.drift = Vec3::Zero();
        const int body = bodies.movable(c.a, c.b);
        if (!bodies.acts[body]) continue;
        if (c.carrier < 0 && !(bodies.isDynamic(c.a) && bodies.isDynamic(c.b))) continue;  // the floor
        const Vec3 &a = bodies.velocities[c.a].angular, &b = bodies.velocities[c.b].angular;
        const Vec3 w = c.carrier == c.a ? a : c.carrier == c.b ? b : Vec3(0.5 * (a + b));
        const double h = bodies.spans[body], size = w.squaredNorm();
        if (size == 0.0 || h * h * size > kMostCarrierTurn * kMostCarrierTurn) continue;
        const Vec3 rho = bodies.poses[c.b].position - bodies.poses[c.a].position;
        const Vec3 before = posesAtStart[c.b].position - posesAtStart[c.a].position;
        c.drift = rho - before;
        const Vec3 u = a.cross(c.armA) - b.cross(c.armB);
        const double share = clamped(w.dot(c.carrier == c.a ? b : a) / size, 0.0, 1.0);
        c.lead = w.cross(c.drift + 0.5 * h * u) + share * restOfChord(w, rho, h);
        c.turn = share * h * w;
    }
}

}  // namespace engine
