/// From this step's contacts to rows, and back to the impulses that persist.
#pragma once
#include "engine/constraints/contact.h"
#include "engine/solver/constraints.h"

namespace engine {

/// Everything the solver of a world keeps from one sub-step to the next.
struct Solver {
    Constraints<double> constraints;
    JointTrees trees;
    std::vector<Pose> posesAtStart;  // of the step, where the contacts' rows were made
};

/// Rows, effective masses and blocks of all contacts, once a step: their arms turn by so little in a
/// step that making them anew every sub-step costs a third more and steadies nothing.
void prepareContacts(std::span<const Contact> contacts, const Bodies& bodies, const Vec3& gravity,
                     const Settings& settings, Solver& solver);

/// C of every contact point, carried along by the bodies since the rows were made:
///   C = C0 + J (way and turn since then)
/// A ball's contact stays below it while it rolls, which an anchor fixed on the ball would not.
/// Every sub-step.
void updateSeparations(const Bodies& bodies, Solver& solver);
double separationNow(const ContactConstraint<double>& contact, const ContactRow<double>& row,
                     const Bodies& bodies, const Solver& solver);

/// Gravity order: contacts from the top down, ties in the order of pairs.
void orderContacts(std::span<const Contact> contacts, const Bodies& bodies, const Vec3& gravity,
                   Order order, std::vector<int>& result);

/// Impulses go back to where the next step finds them.
void storeImpulses(const Solver& solver, std::span<Contact> contacts);

}  // namespace engine
