#include "engine/solver/pressed_bodies.h"

namespace engine {
namespace {

constexpr double kMostRatio = 100.0;  // of the masses of two touching bodies
constexpr double kAgainst = -0.2;     // cosine: opposite sides of a press, or of a wedge
constexpr double kNear = 2e-3;        // m: contacts ahead of touching do not press

bool touches(const Contact& contact, const Bodies& bodies) {
    const Pose &a = bodies.poses[contact.a], &b = bodies.poses[contact.b];
    for (int i = 0; i < contact.count; ++i) {
        const ContactPoint& p = contact.points[i];
        if (contact.normal.dot(b.toWorld(p.anchorB) - a.toWorld(p.anchorA)) < kNear) return true;
    }
    return false;
}

}  // namespace

void PressedBodies::load(std::span<const Contact> contacts, std::span<const Joint> joints,
                         Bodies& bodies) {
    presses_.clear();
    for (const Contact& c : contacts) {
        const double a = bodies.masses[c.a].mass, b = bodies.masses[c.b].mass;
        if (a == 0.0 || b == 0.0 || (a < kMostRatio * b && b < kMostRatio * a)) continue;
        const bool lightA = a < b;
        const int light = lightA ? c.a : c.b;
        if (!touches(c, bodies)) continue;
        slot_.resize(larger(slot_.size(), bodies.masses.size()), -1);
        if (slot_[light] < 0) {
            slot_[light] = static_cast<int>(presses_.size());
            presses_.push_back({light, -1, 0.0, Vec3::Zero()});
        }
        Press& press = presses_[slot_[light]];
        if (larger(a, b) > press.mass)
            press = {light, lightA ? c.b : c.a, larger(a, b), lightA ? Vec3(-c.normal) : c.normal};
    }
    if (presses_.empty()) return;
    for (const Joint& joint : joints)
        if (joint.present) forget(joint.def.a.index), forget(joint.def.b.index);
    for (const Contact& c : contacts)
        for (const int i : {c.a, c.b}) {
            if (slot_[i] < 0 || bodies.massFactors[i] > 1.0) continue;
            const Press& press = presses_[slot_[i]];
            const Vec3 towards = i == c.a ? Vec3(-c.normal) : c.normal;
            if (press.by == c.a || press.by == c.b) continue;  // one body alone does not press
            if (press.normal.dot(towards) > kAgainst || !touches(c, bodies)) continue;
            bodies.massFactors[i] = press.mass / kMostRatio / bodies.masses[i].mass;
            updateInverseInertia(bodies, i);
            pressed_.push_back(i);
        }
    for (const Press& press : presses_) forget(press.body);
}

void PressedBodies::forget(int body) {
    if (body < static_cast<int>(slot_.size())) slot_[body] = -1;
}

void PressedBodies::unload(Bodies& bodies) {
    for (const int i : pressed_) {
        bodies.massFactors[i] = 1.0;
        if (bodies.present[i]) updateInverseInertia(bodies, i);
    }
    pressed_.clear();
}

}  // namespace engine
