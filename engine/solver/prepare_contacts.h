/// Makes rows from this step's contacts, and stores their impulses.
#pragma once
#include "engine/solver/solver.h"

namespace engine {

/// Makes rows, effective masses and blocks of all contacts, once per step: their arms turn so little in a
/// step that remaking them in every sub-step costs a third more without being more stable. Uses the solver's
/// order and islands.
void prepareContacts(std::span<Contact> contacts, std::span<const Joint> joints,
                     Bodies& bodies, const Settings& settings, Solver& solver);

/// The impulses of point i of contact k in this step.
PointImpulses impulsesOf(const Solver& solver, int k, int i);

/// Updates C of every contact point for the motion of the bodies since the rows were made:
///   C = C0 + J (translation and rotation since then)
/// The contact of a rolling ball stays below it, which an anchor fixed to the ball would not. Called in every
/// sub-step.
void updateSeparations(const Bodies& bodies, Solver& solver);
double separationNow(const ContactConstraint& contact, const ContactRow& row, const Bodies& bodies,
                     const Solver& solver);

/// Gravity order: contacts from the top down, ties in the order of pairs. A contact's height is updated only
/// when it has moved. If noise in the heights shuffled the contacts of a layer in every step, each step would
/// have a different error, warm starting would not converge, and a pyramid would sway without end. `result`: empty, or
/// from an earlier call.
void orderContacts(std::span<Contact> contacts, const Bodies& bodies, const Vec3& gravity,
                   Order order, std::vector<std::uint64_t>& keys, std::vector<int>& result);

/// Stores the impulses for the next step.
void storeImpulses(const Solver& solver, std::span<Contact> contacts);

}  // namespace engine
