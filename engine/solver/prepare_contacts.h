/// From this step's contacts to rows, and back to the impulses that persist.
#pragma once
#include "engine/solver/solver.h"

namespace engine {

/// Rows, effective masses and blocks of all contacts, once a step: their arms turn by so little in a
/// step that making them again every sub-step costs a third more and steadies nothing. In the order and with
/// the islands that the solver has.
void prepareContacts(std::span<Contact> contacts, std::span<const Joint> joints,
                     Bodies& bodies, const Settings& settings, Solver& solver);

/// What point i of contact k got in this step.
PointImpulses impulsesOf(const Solver& solver, int k, int i);

/// C of every contact point, carried along by the bodies since the rows were made:
///   C = C0 + J (way and turn since then)
/// A ball's contact stays below it while it rolls, which an anchor fixed on the ball would not.
/// Every sub-step.
void updateSeparations(const Bodies& bodies, Solver& solver);
double separationNow(const ContactConstraint& contact, const ContactRow& row, const Bodies& bodies,
                     const Solver& solver);

/// Gravity order: contacts from the top down, ties in the order of pairs. The height that counts is the
/// one at which a contact was last seen to move: if noise in the heights of a layer shuffled its
/// contacts in every step, each step's error would be another one, and the warm start would carry a
/// quarrel instead of an answer: a pyramid then sways without end.
void orderContacts(std::span<Contact> contacts, const Bodies& bodies, const Vec3& gravity,
                   Order order, std::vector<std::uint64_t>& keys, std::vector<int>& result);

/// Impulses go back to where the next step finds them.
void storeImpulses(const Solver& solver, std::span<Contact> contacts);

}  // namespace engine
