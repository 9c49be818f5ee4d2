#include "engine/collision/contacts.h"

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace engine {
namespace {

Contact withFeatures(std::initializer_list<int> features, double firstImpulse) {
    Contact c;
    for (const int feature : features) {
        ContactPoint& p = c.points[c.count++];
        p.feature = feature;
        p.impulse = firstImpulse++;
        p.anchorA = Vec3(c.count, 0, 0);
    }
    return c;
}

TEST(ContactCaching, ImpulsesFollowTheirFeature) {
    const Contact before = withFeatures({11, 12, 13, 14}, 1.0);
    Contact after = withFeatures({14, 11, 13, 12}, 0.0);
    carryImpulses(before, after);
    EXPECT_EQ(after.points[0].impulse, 4.0);
    EXPECT_EQ(after.points[1].impulse, 1.0);
    EXPECT_EQ(after.points[2].impulse, 3.0);
    EXPECT_EQ(after.points[3].impulse, 2.0);
}

TEST(ContactCaching, ANewNameInTheSamePlaceKeepsItsImpulse) {
    const Contact before = withFeatures({11, 12}, 1.0);
    Contact after = withFeatures({91, 12}, 0.0);
    carryImpulses(before, after);
    EXPECT_EQ(after.points[0].impulse, 1.0);
    EXPECT_EQ(after.points[1].impulse, 2.0);
}

TEST(ContactCaching, ANewPlaceStartsFromNothing) {
    const Contact before = withFeatures({11}, 1.0);
    Contact after = withFeatures({91}, 0.0);
    after.points[0].anchorA = Vec3(5, 0, 0);
    carryImpulses(before, after);
    EXPECT_EQ(after.points[0].impulse, 0.0);
}

// sqrt(mu_a mu_b), and the larger restitution
TEST(Contacts, MixMaterials) {
    Bodies bodies;
    BodyDef a = support::floorPlane(), b = support::body(Shape::sphere(0.5), {0, 0.5, 0});
    a.material.friction = 0.9, b.material.friction = 0.4;
    a.material.restitution = 0.1, b.material.restitution = 0.7;
    addBody(bodies, a, bodies.count());
    addBody(bodies, b, bodies.count());
    ContactFinder finder;
    findContacts(bodies, finder, 0.02, support::kStep);
    ASSERT_EQ(finder.contacts.size(), 1u);
    EXPECT_NEAR(finder.contacts[0].friction, 0.6, 1e-15);
    EXPECT_EQ(finder.contacts[0].restitution, 0.7);
}

/// The contact of a ball on a floor.
Contact meeting(const Material& floor, const Material& ball) {
    Bodies bodies;
    BodyDef a = support::floorPlane(), b = support::body(Shape::sphere(0.5), {0, 0.5, 0});
    a.material = floor, b.material = ball;
    addBody(bodies, a, bodies.count());
    addBody(bodies, b, bodies.count());
    ContactFinder finder;
    findContacts(bodies, finder, 0.02, support::kStep);
    return finder.contacts.at(0);
}

Material surface(double friction, FrictionRule rule, int priority = 0) {
    Material material;
    material.friction = friction;
    material.frictionRule = rule;
    material.priority = priority;
    return material;
}

TEST(Contacts, FrictionFollowsTheRuleFurtherDown) {
    const auto of = [](FrictionRule rule) {
        return meeting(surface(0.9, FrictionRule::none), surface(0.4, rule)).friction;
    };
    EXPECT_EQ(of(FrictionRule::none), 0.0);
    EXPECT_NEAR(of(FrictionRule::geometric), 0.6, 1e-15);
    EXPECT_NEAR(of(FrictionRule::average), 0.65, 1e-15);
    EXPECT_EQ(of(FrictionRule::smaller), 0.4);
    EXPECT_NEAR(of(FrictionRule::product), 0.36, 1e-15);
    EXPECT_EQ(of(FrictionRule::larger), 0.9);
    EXPECT_EQ(meeting(surface(0.9, FrictionRule::larger), surface(0.4, FrictionRule::product)).friction,
              0.9);
}

TEST(Contacts, TheSurfaceOfHigherPrioritySaysAll) {
    Material ice = surface(0.02, FrictionRule::product, 1);
    ice.restitution = 0.1;
    Material rubber = surface(1.1, FrictionRule::larger);
    rubber.restitution = rubber.rolling = 0.8;
    for (const Contact& contact : {meeting(ice, rubber), meeting(rubber, ice)}) {
        EXPECT_EQ(contact.friction, 0.02);
        EXPECT_EQ(contact.restitution, 0.1);
        EXPECT_EQ(contact.rolling, 0.0);
    }
    ice.frictionRule = FrictionRule::none;
    EXPECT_EQ(meeting(ice, rubber).friction, 0.0);
}

/// A cube on another, with contacts found once; then the upper one is moved and they are found again.
Contact afterMoving(double way) {
    Bodies bodies;
    addBody(bodies, support::body(Shape::box({1, 1, 1}), {0, 0.5, 0}), bodies.count());
    addBody(bodies, support::body(Shape::box({1, 1, 1}), {0, 1.5, 0}), bodies.count());
    ContactFinder finder;
    findContacts(bodies, finder, 0.02, support::kStep);
    bodies.poses[1].position.x() += way;
    findContacts(bodies, finder, 0.02, support::kStep);
    return finder.contacts.at(0);
}

TEST(Contacts, StayWhileThePairHardlyMoves) {
    const Contact before = afterMoving(0.0);
    ASSERT_EQ(before.count, 4);
    const auto isSame = [&](const Contact& after) {
        bool same = after.count == before.count;
        for (int i = 0; same && i < before.count; ++i)
            same = after.points[i].anchorA == before.points[i].anchorA &&
                   after.points[i].anchorB == before.points[i].anchorB;
        return same;
    };
    EXPECT_TRUE(isSame(afterMoving(0.004)));
    EXPECT_FALSE(isSame(afterMoving(0.006)));
}

TEST(Contacts, TurnTheirNormalWithTheBody) {
    Bodies bodies;
    addBody(bodies, support::body(Shape::box({1, 1, 1}), {0, 0, 0}), bodies.count());
    addBody(bodies, support::body(Shape::box({1, 1, 1}), {0, 1, 0}), bodies.count());
    ContactFinder finder;
    findContacts(bodies, finder, 0.02, support::kStep);
    const Quat turn = Quat(1.0, 0.0, 0.0, 0.3).normalized();
    for (Pose& pose : bodies.poses) pose = {turn * pose.position, turn * pose.rotation};
    findContacts(bodies, finder, 0.02, support::kStep);
    ASSERT_EQ(finder.contacts.size(), 1u);
    EXPECT_NEAR((finder.contacts[0].normal - turn * Vec3::UnitY()).norm(), 0.0, 1e-14);
}

TEST(Contacts, AFastPairIsSeenFromFartherAway) {
    Bodies bodies;
    addBody(bodies, support::floorPlane(), bodies.count());
    BodyDef ball = support::body(Shape::sphere(0.5), {0, 0.7, 0});
    addBody(bodies, ball, bodies.count());
    ContactFinder slow, fast;
    findContacts(bodies, slow, 0.02, support::kStep);
    bodies.velocities[1].linear = {0, -18, 0};  // 30 cm per step
    findContacts(bodies, fast, 0.02, support::kStep);
    EXPECT_EQ(slow.contacts.size(), 0u);
    EXPECT_EQ(fast.contacts.size(), 1u);
}

// A boom whose tip comes down 2 mm in a step, where 1 mm is open, beside what it may pass; in either order.
TEST(Contacts, OfABoomThatTurnsSlowlyMayPass) {
    for (const int boom : {0, 1}) {
        Bodies bodies;
        BodyDef defs[2];
        defs[boom] = support::body(Shape::box({20, 1, 1}), {0, 0, 0});
        defs[boom].spin = {0, 0, 0.002 / 9.0 / support::kStep};
        defs[1 - boom] = support::body(Shape::box({1, 1, 1}), {9, 1.001, 0});
        MovingPairs moving;
        for (const int i : {0, 1}) addBody(bodies, defs[i], i);
        for (const int i : {0, 1}) moving.motions.push_back(motionOf(bodies, i, support::kStep));
        Contact contact;
        contact.a = 0, contact.b = 1, contact.count = 1;
        contact.normal = {0, boom == 0 ? 1.0 : -1.0, 0};
        Vec3 anchors[2];
        anchors[boom] = {9, 0.5, 0}, anchors[1 - boom] = {0, -0.5, 0};
        contact.points[0].anchorA = anchors[0], contact.points[0].anchorB = anchors[1];
        EXPECT_TRUE(mayPass(contact, bodies, moving, support::kStep)) << boom;
        moving.motions[boom].spin = Vec3::Zero();
        EXPECT_FALSE(mayPass(contact, bodies, moving, support::kStep)) << boom;
    }
}

}  // namespace
}  // namespace engine
