/// Friction on bodies that turn. In every sub-step a rider must move along the chord of its circle. The rows
/// know only the tangent where they were made, at the beginning of the step, and along tangents a box on a
/// disc leaves its circle: it creeps outwards as r e^(w^2 t dt / 2).
///
/// The contact keeps its place under the rider, so the carrier's arm changes with rho, from the centre of a
/// to that of b. With the carrier's spin w, friction has to bring J v - lead to 0:
///   lead = w x (rho + (h/2) u - rho_0),   u = w_a x r_a - w_b x r_b: without slip, the rate of rho
/// rho_0 belongs to the rows and rho is now; h/2 leads to the middle of the sub-step. For a rider that turns
/// with its carrier, the rest of the exact chord is added, in the share c of w that it has:
///   + c ((R(h w) - 1) rho / h - w x (rho + (h/2) w x rho))
/// The force that holds a rider turns too, so the impulses from which friction starts are turned by c h w.
/// Without that, sweeps that end at their tolerance leave the same error in every sub-step.
///
/// The rows' arms are those of the beginning of the step, too: a carrier that is not kinematic would be turned by what
/// holds its riders inwards, P, as if they were where they had been. It gets what is missing, from
///   L = -(rho - rho_0) x P
/// without which a merry-go-round with two blocks of 100 kg gained 42 % of its energy in ten seconds.
///
/// Only islands on a moving kinematic body, or on a body held by a hinge, are concerned.
#pragma once
#include <span>
#include <vector>

#include "engine/base/disjoint_sets.h"
#include "engine/constraints/contact.h"
#include "engine/constraints/joint_constraint.h"
#include "engine/dynamics/bodies.h"

namespace engine {

/// A contact of such an island.
struct RidingContact {
    int number = -1, count = 0;  // index of the contact, and its points
    int carrier = -1;         // a or b, the body that carries the other; -1: neither, w is their mean
    int a = -1, b = -1;
    Vec3 armA, armB;          // m, to the middle of its points, when the rows were made
    Vec3 lead = Vec3::Zero(); // m/s, of b relative to a, in this sub-step
    Vec3 turn = Vec3::Zero(); // rad, of the start impulses
    Vec3 drift = Vec3::Zero();  // m, rho - rho_0
};

class RidingContacts {
public:
    /// At the beginning of a step: collects the contacts of islands on turning bodies.
    void find(std::span<const Contact> contacts, std::span<const Joint> joints, const Bodies& bodies,
              DisjointSets& islands);
    /// At the beginning of a sub-step: sets the leads.
    void begin(const Bodies& bodies, std::span<const Pose> posesAtStart);

    /// After a sub-step's impulses, of which impulseOf(riding contact) is the sum on b, N s: turns carriers by what
    /// the arms lack. Returns whether there are any.
    template <class ImpulseOf>
    bool finish(Bodies& bodies, const ImpulseOf& impulseOf) const {
        bool any = false;
        for (const RidingContact& c : list_) {
            if (c.carrier < 0 || !bodies.isDynamic(c.carrier) || c.drift.isZero(0.0)) continue;
            bodies.velocities[c.carrier].angular -=
                bodies.inverseMasses[c.carrier].angular * c.drift.cross(impulseOf(c));
            any = true;
        }
        return any;
    }

    std::span<const RidingContact> list() const { return list_; }

private:
    void markCarriers(std::span<const Joint> joints, const Bodies& bodies);

    std::vector<RidingContact> list_;
    std::vector<char> carries_;  // by body
    std::vector<char> rides_;    // by leader of an island
    std::vector<int> carriers_;
};

}  // namespace engine
