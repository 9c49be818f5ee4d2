/// Bounces, before everything else in a sub-step: J v2 = -e J v1, one pair after the other, so that an impact
/// travels through a row of balls (first seed, 'Restitution'; Eberly).
///
/// A pair meets within the sub-step, at the time t when its gap C closes. With the relative acceleration a
/// along the normal, and velocities that belong to half a sub-step ago (dynamics/energy.h), it arrives with u
/// and leaves so that the sub-step ends as in free flight from the bounce:
///   u_0 = J v - a h / 2,   u = -sqrt(u_0^2 - 2 a C),   t = 2 C / (-u_0 - u)
///   J v2 = -e u + a (h / 2 - t)
///   x <- x - t (v3 - v),   because until t the bodies moved with v; v3 is the velocity after friction and all else,
///                          or v2 where a joint, or another contact that a fast body reaches, may act before t
/// So a ball reverses on the floor and not above it, and with e = 1 it keeps its energy. Of the points of a contact
/// those bounce together that touch at the time of the first; a corner that comes down later bounces alone.
#pragma once
#include <span>
#include <vector>

#include "engine/constraints/contact_constraint.h"
#include "engine/constraints/joint_constraint.h"
#include "engine/dynamics/bodies.h"
#include "engine/settings.h"

namespace engine {

/// A contact that may bounce; in its rows only n, the arms, the gap and the bounce are set.
struct ContactImpact {
    ContactConstraint contact;
    int number = -1;                                  // index of the contact
    double acceleration[Contact::kMaxPoints] = {};    // a of each point, m/s^2
    double ahead[Contact::kMaxPoints] = {};  // m: what the bounces of this sub-step add to the gap, besides v
    bool placed = false;  // gaps, accelerations and block are up to date for this sub-step
};

class Impacts {
public:
    /// At the beginning of a step: collects, at the initial poses, the contacts with restitution, and the oblique hits
    /// of two bodies without.
    void prepare(std::span<const Contact> contacts, std::span<const Joint> joints, const Bodies& bodies);
    bool empty() const { return list_.empty(); }

    /// Before a sub-step is solved: gaps and accelerations will be taken at this time.
    void begin(const Bodies& bodies, std::span<const Pose> posesAtStart);
    /// Solves all bounces of the sub-step, for acting bodies; updates `v`.
    void solve(std::span<Velocity> v, const Settings& settings);
    /// After the bodies have moved: corrects the positions of those that bounced.
    void movePositions(Bodies& bodies) const;

    /// The contacts, with the bounces in their rows.
    std::span<const ContactImpact> list() const { return list_; }

private:
    struct Body {
        Velocity way;        // m, rad: correction of the motion with its final v
        Velocity after;      // m/s, rad/s: after its bounces, before all other impulses
        double time = 0.0;   // s, of its last impact
        bool met = false;
        bool jointed = false, touched = false;  // by a joint; by a contact that is not in the list
        bool slow = false;                      // before its bounces, so that it rests on what it touches

        void beginSubstep() { way = after = {}, time = 0.0, met = slow = false; }
        /// Whether all that acts on it besides its bounces acts after them.
        bool isFree() const { return !jointed && (!touched || slow); }
    };
    bool bounce(ContactImpact& impact, std::span<Velocity> v, const Settings& settings, double h);
    void place(ContactImpact& impact) const;
    void note(int body, double time, const Velocity& before, double h);

    const Bodies* all_ = nullptr;  // of this sub-step
    std::span<const Pose> starts_;

    std::vector<ContactImpact> list_;
    std::vector<Body> bodies_;
    std::vector<int> met_;  // bodies that bounced
};

}  // namespace engine
