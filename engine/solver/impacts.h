/// Bounces, before everything else of a sub-step: J v2 = -e J v1, one pair after the other, so that a blow
/// travels through a row of balls (first seed, 'Restitution'; Eberly).
///
/// A pair meets within the sub-step, at the time t where its gap C closes. With the relative
/// acceleration a along the normal, and velocities that are those of half a sub-step ago
/// (dynamics/energy.h), it comes with u and leaves so that the sub-step ends as if it had flown on:
///   u_0 = J v - a h / 2,   u = -sqrt(u_0^2 - 2 a C),   t = 2 C / (-u_0 - u)
///   J v2 = -e u + a (h / 2 - t)
///   x <- x - t (v2 - v),   because until t the bodies moved with v
/// So a ball turns round on the floor and not above it, and with e = 1 keeps its energy.
#pragma once
#include <span>
#include <vector>

#include "engine/constraints/contact_constraint.h"
#include "engine/dynamics/bodies.h"
#include "engine/settings.h"

namespace engine {

/// A contact that may bounce; of its rows n, the arms, the gap and the bounce are filled in.
struct ContactImpact {
    ContactConstraint contact;
    int number = -1;                                  // among the contacts
    double acceleration[Contact::kMaxPoints] = {};    // a of every point, m/s^2
    bool placed = false;  // its gaps, accelerations and block are those of this sub-step
};

class Impacts {
public:
    /// Of a step: the contacts with restitution, at the poses where the step begins.
    void prepare(std::span<const Contact> contacts, const Bodies& bodies);
    bool empty() const { return list_.empty(); }

    /// Of a sub-step, before it is solved: gaps and accelerations will be those of now.
    void begin(const Bodies& bodies, std::span<const Pose> posesAtStart);
    /// All bounces of it, of the bodies whose turn it is; `v` afterwards.
    void solve(std::span<Velocity> v, const Settings& settings);
    /// After the bodies were moved: those that bounced are put where they met.
    void movePositions(Bodies& bodies) const;

    /// With the bounces in their rows.
    std::span<const ContactImpact> list() const { return list_; }

private:
    struct Body {
        Velocity way;        // m, rad: what its place differs by from moving with its v all along
        double time = 0.0;   // s, of its last impact
        bool met = false;
    };
    bool bounce(ContactImpact& impact, std::span<Velocity> v, double threshold, double h);
    void place(ContactImpact& impact) const;

    const Bodies* all_ = nullptr;  // in this sub-step
    std::span<const Pose> starts_;

    std::vector<ContactImpact> list_;
    std::vector<Body> bodies_;
    std::vector<int> met_;  // bodies that bounced
};

}  // namespace engine
