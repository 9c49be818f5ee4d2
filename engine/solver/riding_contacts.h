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
    int number = -1;          // index of the contact
    int carrier = -1;         // a or b, the body that carries the other; -1: neither, w is their mean
    int a = -1, b = -1;
    Vec3 armA, armB;          // m, to the middle of its points, when the rows were made
    Vec3 lead = Vec3::Zero(); // m/s, of b relative to a, in this sub-step
    Vec3 turn = Vec3::Zero(); // rad, of the start impulses
};

class RidingContacts {
public:
    /// At the beginning of a step: collects the contacts of islands on turning bodies.
    void find(std::span<const Contact> contacts, std::span<const Joint> joints, const Bodies& bodies,
              DisjointSets& islands);
    /// At the beginning of a sub-step: sets the leads.
    void begin(const Bodies& bodies, std::span<const Pose> posesAtStart);

    std::span<const RidingContact> list() const { return list_; }

private:
    void markCarriers(std::span<const Joint> joints, const Bodies& bodies);

    std::vector<RidingContact> list_;
    std::vector<char> carries_;  // by body
    std::vector<char> rides_;    // by leader of an island
    std::vector<int> carriers_;
};

}  // namespace engine
