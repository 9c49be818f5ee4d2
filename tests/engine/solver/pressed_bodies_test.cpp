// A light body between heavy ones (solver/pressed_bodies.h).
#include "engine/solver/pressed_bodies.h"

#include <gtest/gtest.h>

#include "engine/solver/paces.h"
#include "engine/solver/prepare_contacts.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

Contact touching(int a, int b, const Bodies& bodies) {
    Contact contact;
    contact.a = a, contact.b = b, contact.count = 1;
    contact.normal = Vec3::UnitY();
    const Vec3 middle = 0.5 * (bodies.poses[a].position + bodies.poses[b].position);
    contact.points[0].anchorA = bodies.poses[a].toLocal(middle);
    contact.points[0].anchorB = bodies.poses[b].toLocal(middle);
    return contact;
}

/// A gram on the floor under a tonne, next to a gram on a tonne.
struct Pressing {
    Bodies bodies;
    std::vector<Contact> contacts;
    PressedBodies pressed;

    Pressing() {
        addBody(bodies, support::fixed(Shape::box({10, 1, 10})), 0);
        for (const double mass : {1e-3, 1e3, 1e3, 1e-3})
            addBody(bodies, support::body(Shape::sphere(0.5), {0, bodies.count() % 2 ? 1.0 : 2.0, 0}, mass),
                    bodies.count());
        contacts = {touching(0, 1, bodies), touching(0, 3, bodies), touching(1, 2, bodies),
                    touching(3, 4, bodies)};
    }
};

TEST(PressedBodies, CountForAHundredthOfWhatPressesThemUntilTheStepEnds) {
    Pressing pile;
    const Mat3 before = pile.bodies.inverseMasses[1].angular;
    pile.pressed.load(pile.contacts, {}, pile.bodies);
    EXPECT_NEAR(pile.bodies.inverseMasses[1].linear, 1.0 / 10.0, 1e-12);
    EXPECT_TRUE((1e4 * pile.bodies.inverseMasses[1].angular).isApprox(before, 1e-12));
    for (const int other : {2, 3, 4}) EXPECT_EQ(pile.bodies.massFactors[other], 1.0) << other;
    pile.pressed.unload(pile.bodies);
    EXPECT_EQ(pile.bodies.inverseMasses[1].linear, 1e3);
    EXPECT_TRUE(pile.bodies.inverseMasses[1].angular.isApprox(before, 1e-15));
}

TEST(PressedBodies, WithAJointKeepTheirMass) {
    Pressing pile;
    Joint joint;
    joint.def.a = {1}, joint.def.b = {4};
    pile.pressed.load(pile.contacts, std::span(&joint, 1), pile.bodies);
    EXPECT_EQ(pile.bodies.massFactors[1], 1.0);
}

// The heaviest of those that press counts, in any order of the contacts.
TEST(PressedBodies, CountForAHundredthOfTheHeaviest) {
    for (const bool heaviestLast : {false, true}) {
        Pressing pile;
        const int lighter = pile.bodies.count();
        addBody(pile.bodies, support::body(Shape::sphere(0.5), {0, 2, 0}, 100.0), lighter);
        pile.contacts = {touching(0, 1, pile.bodies), touching(1, 2, pile.bodies), touching(1, lighter, pile.bodies)};
        if (heaviestLast) std::swap(pile.contacts[1], pile.contacts[2]);
        pile.pressed.load(pile.contacts, {}, pile.bodies);
        EXPECT_NEAR(pile.bodies.inverseMasses[1].linear, 1.0 / 10.0, 1e-12) << heaviestLast;
    }
}

// A light body that flies around the edge of a heavy one has contacts with both of its sides.
TEST(PressedBodies, AreNotThoseThatOneBodyTouchesFromTwoSides) {
    Pressing pile;
    pile.bodies.poses[2].position.y() = 1.0;
    pile.contacts = {touching(1, 2, pile.bodies), touching(1, 2, pile.bodies)};
    pile.contacts[1].normal = -Vec3::UnitY();
    pile.pressed.load(pile.contacts, {}, pile.bodies);
    EXPECT_EQ(pile.bodies.massFactors[1], 1.0);
    pile.contacts.push_back(touching(0, 1, pile.bodies));
    pile.pressed.load(pile.contacts, {}, pile.bodies);
    EXPECT_GT(pile.bodies.massFactors[1], 1.0);
}

// The heavy body must touch: a contact ahead of touching does not press.
TEST(PressedBodies, AreNotThoseThatAHeavyOneComesNear) {
    Pressing pile;
    pile.bodies.poses[2].position.y() += 0.01;
    pile.pressed.load(pile.contacts, {}, pile.bodies);
    EXPECT_EQ(pile.bodies.massFactors[1], 1.0);
}

// Contacts may be prepared anew within a step, and a step may be undone before it ends.
TEST(PressedBodies, HaveTheirMassAgainWhenContactsArePreparedAnew) {
    Pressing pile;
    Solver solver;
    for (const bool pressed : {true, false, true}) {
        const std::span<Contact> contacts = std::span(pile.contacts).first(pressed ? pile.contacts.size() : 0);
        connect(contacts, {}, pile.bodies, solver.islands);
        orderContacts(contacts, pile.bodies, Vec3(0, -1, 0), Order::gravity, solver.keys, solver.order);
        prepareContacts(contacts, {}, pile.bodies, Settings{}, solver);
        EXPECT_EQ(pile.bodies.massFactors[1] > 1.0, pressed);
    }
}

}  // namespace
}  // namespace engine
