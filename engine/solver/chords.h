/// Joints outside the trees, and limits, follow the chord of their motion. Their rows know only its tangent, but
///   C(q + h v) = C + h (J v + kappa),   kappa = O(h v^2)
/// A bead that moves along the tangent leaves its ring. Nudges bring it back, but they take angular momentum and
/// energy with them: it lost 38 % of its speed in a minute. With kappa as a part of the bias it keeps both. Trees
/// that no other joint acts on have RATTLE instead (joint_nudges.h), and friction on turning bodies has
/// riding_contacts.h.
#pragma once
#include "engine/dynamics/bodies.h"
#include "engine/dynamics/rotation.h"

namespace engine {

/// The bodies of a joint at the end of the next sub-step, if nothing changes their velocities.
struct Chord {
    double h = 0.0;  // s; 0: unknown, or they turn too fast
    Pose a, b;

    Chord(const Bodies& bodies, int bodyA, int bodyB) {
        constexpr double kFarthest = 0.5;  // rad
        const double span = bodies.spans[bodies.movable(bodyA, bodyB)];
        const auto ahead = [&](int i) {
            const Pose& pose = bodies.poses[i];
            const Velocity& v = bodies.velocities[i];
            return Pose{pose.position + span * v.linear, turnedBy(span * v.angular, pose.rotation)};
        };
        for (const int i : {bodyA, bodyB})
            if (span * bodies.velocities[i].angular.norm() > kFarthest) return;
        h = span, a = ahead(bodyA), b = ahead(bodyB);
    }
    /// kappa of a row, from C at the end, C now and J v now.
    double bend(double atEnd, double now, double rate) const { return (atEnd - now) / h - rate; }
};

}  // namespace engine
