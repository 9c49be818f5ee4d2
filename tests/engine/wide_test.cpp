// The wide contact solver: which contacts are solved together, the same bits on every instruction set, and
// the same results as rows in double precision.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/solver/paces.h"
#include "engine/solver/prepare_contacts.h"
#include "engine/wide/contact_kernels.h"
#include "engine/wide/schedule.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::kStep;

/// A moving heap: boxes and balls, some bouncing.
World heap(const Settings& settings) {
    World world(settings);
    world.add(support::floorPlane());
    for (int i = 0; i < 60; ++i) {
        const Vec3 at(0.6 * (i % 4) + 0.05 * (i % 7), 0.5 + 0.55 * (i / 8), 0.7 * (i % 2));
        BodyDef def = i % 3 == 0 ? body(Shape::sphere(0.3), at) : body(Shape::box({0.6, 0.5, 0.6}), at);
        def.material.restitution = i % 5 == 0 ? 0.4 : 0.0;
        world.add(def);
    }
    return world;
}

TEST(Schedule, KeepsTheOrderOfContactsThatShareABody) {
    // A chain 0-1-2-3-4 and five separate pairs.
    std::vector<BodyPair> pairs{{0, 1}, {1, 2}, {2, 3}, {3, 4}};
    for (int i = 5; i < 15; i += 2) pairs.push_back({i, i + 1});
    const std::vector<int> order{3, 2, 1, 0, 4, 5, 6, 7, 8};
    Schedule schedule;
    schedule.begin(15);
    schedule.add(pairs, order);
    std::vector<int> batchOf(pairs.size(), -1);
    for (int k = 0; k < static_cast<int>(schedule.batches().size()); ++k)
        for (const int contact : schedule.batches()[k])
            if (contact >= 0) batchOf[contact] = k;
    EXPECT_LT(batchOf[3], batchOf[2]);
    EXPECT_LT(batchOf[2], batchOf[1]);
    EXPECT_LT(batchOf[1], batchOf[0]);
    for (int i = 4; i < 9; ++i) EXPECT_EQ(batchOf[i], 0) << i;  // in the free lanes
}

TEST(Schedule, FixedBodiesTieNothingTogether) {
    std::vector<BodyPair> pairs(8);
    for (int i = 0; i < 8; ++i) pairs[i] = {-1, i};
    Schedule schedule;
    schedule.begin(8);
    schedule.add(pairs, std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7});
    EXPECT_EQ(schedule.batches().size(), 1u);
}

TEST(Schedule, AGroupBeginsItsOwnBatches) {
    const std::vector<BodyPair> pairs{{0, 1}, {2, 3}};
    Schedule schedule;
    schedule.begin(4);
    schedule.add(pairs, std::vector<int>{0});
    schedule.add(pairs, std::vector<int>{1});
    ASSERT_EQ(schedule.batches().size(), 2u);
    EXPECT_EQ(schedule.batches()[0][0], 0);
    EXPECT_EQ(schedule.batches()[1][0], 1);
}

/// Contacts of body pairs (i, i + 1) at these heights, in the order of a sweep. `order`: the last one, or empty.
std::vector<int> orderOf(std::vector<Contact>& contacts, const std::vector<double>& heights,
                         std::vector<int> order = {}) {
    Bodies bodies;
    for (const double height : heights)
        addBody(bodies, body(Shape::sphere(0.1), {0, height, 0}), bodies.count());
    std::vector<std::uint64_t> keys;
    orderContacts(contacts, bodies, Vec3(0, -9.81, 0), Order::gravity, keys, order);
    return order;
}

TEST(Order, IsFromTheTopDownAndDoesNotHeedNoise) {
    std::vector<Contact> contacts(3);
    for (int i = 0; i < 3; ++i) contacts[i].a = i, contacts[i].b = (i + 1) % 3, contacts[i].count = 1;
    EXPECT_EQ(orderOf(contacts, {1.0, 1.0 + 1e-9, 5.0}), (std::vector<int>{2, 0, 1}));
    EXPECT_EQ(orderOf(contacts, {1.0, 1.01, 5.0}), (std::vector<int>{2, 0, 1}));   // noise
    EXPECT_EQ(orderOf(contacts, {1.0, 1.05, 5.0}), (std::vector<int>{2, 1, 0}));   // it has moved
    EXPECT_EQ(orderOf(contacts, {1.0, 1.04, 0.5}), (std::vector<int>{1, 0, 2}));
}

TEST(Order, OfTheLastStepIsKeptOnlyIfItStillHolds) {
    std::vector<Contact> contacts(3);
    for (int i = 0; i < 3; ++i) contacts[i].a = i, contacts[i].b = (i + 1) % 3, contacts[i].count = 1;
    const std::vector<int> before = orderOf(contacts, {1.0, 2.0, 3.0});
    EXPECT_EQ(orderOf(contacts, {1.0, 2.0, 3.0}, before), before);
    EXPECT_EQ(orderOf(contacts, {4.0, 2.0, 3.0}, before), (std::vector<int>{0, 2, 1}));
    contacts.pop_back();
    EXPECT_EQ(orderOf(contacts, {4.0, 5.0, 3.0}, before), (std::vector<int>{1, 0}));
}

TEST(Lanes, GiveTheSameBitsOnEveryInstructionSet) {
    Settings baseline = Settings::steady();
    baseline.instructions = Instructions::baseline;
    if (&contactKernels(Instructions::best) == &contactKernels(Instructions::baseline))
        GTEST_SKIP() << "this processor has the baseline only";
    World one = heap(Settings::steady()), other = heap(baseline);
    for (int i = 0; i < 180; ++i) {
        one.step(kStep), other.step(kStep);
        ASSERT_EQ(one.hash(), other.hash()) << "step " << i;
    }
}

// One step from the same state, both solved until nothing changes: the same impulses.
TEST(Lanes, AgreeWithRowsInDoublePrecision) {
    Settings lanes = Settings::steady(), rows = Settings::steady();
    for (Settings* s : {&lanes, &rows}) s->sweeps = s->movingSweeps = 400, s->tolerance = 0.0;
    rows.lanes = false;
    World a = heap(lanes), b = heap(rows);
    for (int i = 0; i < 2; ++i) a.step(kStep), b.step(kStep);
    for (int i = 1; i < a.bodyCount(); ++i) {
        const BodyId id{i};
        EXPECT_LT((a.velocity(id) - b.velocity(id)).norm(), 2e-5) << i;
        EXPECT_LT((a.spin(id) - b.spin(id)).norm(), 2e-4) << i;
    }
}

/// 528 boxes with gaps between them, one group with more than 1024 contacts.
void addPyramid(World& world) {
    world.add(support::floorPlane());
    for (int row = 0; row < 32; ++row)
        for (int i = row; i < 32; ++i)
            world.add(body(Shape::box({1, 1, 1}), {1.02 * i - 0.51 * row, 0.5 + row, 0}));
}

// A large group is swept in halves: a step's report does not depend on the number of threads.
TEST(Lanes, ReportTheSameSweepsWithTwoThreads) {
    const auto pyramid = [](int threads) {
        Settings settings = Settings::steady();
        settings.threads = threads;
        World world(settings);
        addPyramid(world);
        for (int i = 0; i < 5; ++i) world.step(kStep);
        return world;
    };
    const World one = pyramid(1), two = pyramid(2);
    const std::vector<SweepReport>&a = one.report().sweeps, &b = two.report().sweeps;
    ASSERT_GT(a.size(), 8u);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].residual, b[i].residual) << i;
        EXPECT_EQ(a[i].delta, b[i].delta) << i;
    }
    EXPECT_EQ(one.errors().penetration, two.errors().penetration);
}

// The worst row is in the half that is swept first: what it lacks counts as much as in one list of rows.
TEST(Lanes, ReportTheResidualOfBothHalves) {
    const auto struck = [](bool lanes) {
        Settings settings = Settings::steady();
        settings.sweeps = settings.movingSweeps = settings.minSweeps = 6, settings.tolerance = 0.0;
        settings.lanes = lanes;
        World world(settings);
        addPyramid(world);
        world.setVelocity({world.bodyCount() - 1}, {0, -1, 0}, {0, 0, 0});
        world.step(kStep);
        return world;
    };
    const World wide = struck(true), rows = struck(false);
    const std::vector<SweepReport>&a = wide.report().sweeps, &b = rows.report().sweeps;
    ASSERT_EQ(a.size(), b.size());
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(a[i].residual, b[i].residual, 0.01 * b[i].residual) << i;
    EXPECT_GT(a[0].residual, 0.3);
}

TEST(Lanes, AnIslandAtRestPaysNothingForOneThatMoves) {
    const auto topOf = [](bool withMoving) {
        World world;
        world.add(support::floorPlane());
        for (int row = 0; row < 12; ++row)  // a pyramid
            for (int i = row; i < 12; ++i)
                world.add(body(Shape::box({1, 1, 1}), {1.1 * i - 0.55 * row, 0.5 + row, 0}));
        for (int i = 0; withMoving && i < 40; ++i) {
            BodyDef def = body(Shape::box({1, 1, 1}), {30.0 + i % 5, 0.5 + i / 5, 0});
            def.velocity = Vec3(3.0, 2.0 * (i % 3), 0);
            world.add(def);
        }
        for (int i = 0; i < 60; ++i) world.step(kStep);
        return world.pose({78}).position;
    };
    EXPECT_LT((topOf(true) - topOf(false)).norm(), 1e-12);
}

/// Pairs 1-2, 3-4 ... 15-16 are joined; 1 and 3 lie on the floor with twenty contacts, 17 with three. One solve is
/// enough for 1 to 12; 9 to 12 have limits.
struct EightPairs {
    Bodies bodies;
    std::vector<Contact> contacts;
    std::vector<Joint> joints;
    DisjointSets islands;
    ContactGroups groups;

    EightPairs() {
        for (int i = 0; i < 18; ++i) {
            BodyDef def = body(Shape::sphere(0.5), Vec3(3.0 * i, 0.5, 0), 1.0);
            if (i == 0) def.kind = BodyKind::fixed;
            addBody(bodies, def, i);
        }
        setSpans(bodies, kStep);
        for (int i = 1; i < 17; i += 2) {
            Joint joint;
            joint.def.a = {i}, joint.def.b = {i + 1};
            joint.solvedAtOnce = i < 13, joint.acts = i == 9 || i == 11;
            joints.push_back(joint);
        }
        for (const auto& [body, count] : {std::pair{1, 20}, {3, 20}, {17, 3}})
            for (int k = 0; k < count; ++k) {
                Contact contact;
                contact.a = 0, contact.b = body;
                contacts.push_back(contact);
            }
        connect(contacts, joints, bodies, islands);
        groups.find(contacts, joints, bodies, islands);
    }
    int ofPair(int a) { return groups.ofJoint(a, a + 1, bodies, islands); }
};

TEST(ContactGroups, HoldIslandsWithJointsApartFromOthersAndFromEachOther) {
    EightPairs s;
    EXPECT_EQ(s.ofPair(1), s.groups.of(0));
    EXPECT_EQ(s.ofPair(3), s.groups.of(20));
    EXPECT_NE(s.ofPair(1), s.ofPair(3));
    EXPECT_EQ(s.ofPair(5), s.ofPair(7));  // nothing touches them: one solve for all
    EXPECT_EQ(s.ofPair(9), s.ofPair(11));
    EXPECT_NE(s.ofPair(7), s.ofPair(9));
    EXPECT_NE(s.ofPair(13), s.ofPair(15));  // each is swept as often as it needs
    for (const int pair : {1, 3, 5, 9, 13}) EXPECT_TRUE(s.groups.hasJoints(s.ofPair(pair)));
    EXPECT_FALSE(s.groups.hasJoints(s.groups.of(40)));
    EXPECT_TRUE(s.groups.isTouched(s.ofPair(3)));
    EXPECT_FALSE(s.groups.isTouched(s.ofPair(5)));
    EXPECT_TRUE(std::ranges::equal(s.groups.jointedBodies(s.ofPair(3)), std::vector{3}));
    EXPECT_TRUE(s.groups.jointedBodies(s.ofPair(5)).empty());
    EXPECT_EQ(s.groups.jointedBodies().size(), 2u);  // nothing touches the others of their pairs
}

}  // namespace
}  // namespace engine
