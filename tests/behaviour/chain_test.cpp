// mission 34 and heavy loads on light links.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "engine/base/trigonometry.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::kGravity;
using support::kStep;
using support::run;

/// `links` of 1 kg and half a metre, straight down or level, and a ball (0 = none).
struct Chain {
    World world;
    std::vector<JointId> joints;

    Chain(int links, double ballMass, bool level, const Settings& settings = Settings::steady())
        : world(settings) {
        const Vec3 along = level ? Vec3(1, 0, 0) : Vec3(0, -1, 0);
        BodyId last = world.add(support::hook());
        const Vec3 size = level ? Vec3(0.5, 0.1, 0.1) : Vec3(0.1, 0.5, 0.1);
        for (int i = 0; i < links; ++i) {
            BodyDef link = body(Shape::box(size), along * (0.5 * i + 0.25), 1.0);
            link.collide = false;
            last = hang(last, link, along * (0.5 * i));
        }
        if (ballMass == 0.0) return;
        BodyDef ball = body(Shape::sphere(0.5), along * (0.5 * links + 0.5), ballMass);
        ball.collide = false;
        hang(last, ball, along * (0.5 * links));
    }
    BodyId hang(BodyId last, const BodyDef& def, const Vec3& at) {
        const BodyId next = world.add(def);
        joints.push_back(support::join(world, JointType::ball, last, next, at));
        return next;
    }
};

TEST(Chain, TheTopJointCarriesTheWeightOfAll) {
    for (const Settings& settings : {Settings::steady(), Settings::seed()}) {
        Chain chain(10, 0.0, false, settings);
        run(chain.world, 120);
        EXPECT_NEAR(chain.world.joint(chain.joints[0]).force.y(), 98.1, 5e-5);  // on the link below
    }
}

TEST(Chain, HoldsAThousandKilogramsOnOneKilogramLinks) {
    Chain chain(20, 1000.0, false);
    double worst = 0.0;
    for (int i = 0; i < 300; ++i) {
        chain.world.step(kStep);
        worst = larger(worst, chain.world.errors().separation);
    }
    EXPECT_LT(worst, 1e-5);
}

TEST(Chain, SwingsAThousandKilogramsWithoutTearingOrGaining) {
    Chain chain(20, 1000.0, true);
    const double scale = 1000 * kGravity * 10.5;
    double worst = 0.0, gain = 0.0;
    for (int i = 0; i < 600; ++i) {
        ASSERT_TRUE(chain.world.step(kStep));
        worst = larger(worst, chain.world.errors().separation);
        gain = larger(gain, chain.world.report().energy.total() / scale);
    }
    EXPECT_LT(worst, 2e-3);
    EXPECT_LT(gain, 5e-3);
}

// Parallel hinges between two banks constrain the perpendicular directions twice.
TEST(Bridge, OfHingesAtBothBanksCarriesAFallingCrate) {
    World world;
    const BodyId left = world.add(support::fixed(Shape::box({1, 1, 2}), {-5.5, 0, 0}));
    const BodyId right = world.add(support::fixed(Shape::box({1, 1, 2}), {5.5, 0, 0}));
    BodyId last = left;
    for (int i = 0; i < 20; ++i) {
        const double x = -5.0 + 0.5 * i;
        const auto sag = [](double at) { return -0.6 * (1.0 - at * at / 25.0); };
        BodyDef plank = body(Shape::box({0.48, 0.1, 2}), {x + 0.25, sag(x + 0.25), 0}, 20.0);
        const BodyId next = world.add(plank);
        support::join(world, JointType::hinge, last, next, {x, sag(x), 0});
        last = next;
    }
    support::join(world, JointType::hinge, last, right, {5, 0, 0});
    world.add(body(Shape::box({0.8, 0.8, 0.8}), {0.3, 1.5, 0.3}, 150.0));
    for (int i = 0; i < 300; ++i) ASSERT_TRUE(world.step(kStep)) << i;
    EXPECT_LT(world.errors().separation, 0.02);
}

TEST(Weld, HoldsACantileverOfFiveBlocks) {
    World world;
    BodyId last = world.add(support::fixed(Shape::box({1, 1, 1})));
    for (int i = 1; i <= 5; ++i) {
        const BodyId next = world.add(body(Shape::box({1, 1, 1}), {1.0 * i, 0, 0}, 10.0));
        support::join(world, JointType::weld, last, next, {i - 0.5, 0, 0});
        last = next;
    }
    run(world, 300);
    EXPECT_NEAR(world.pose(last).position.y(), 0.0, 1e-4);
    // The moment at the wall: sum of m g x from the first joint.
    const JointState root = world.joint({0});
    EXPECT_NEAR(root.force.y(), 5 * 10 * kGravity, 0.5);
    EXPECT_NEAR(root.torque.z(), 10 * kGravity * (0.5 + 1.5 + 2.5 + 3.5 + 4.5), 2.0);
}

// The stretched springs swing the light body many times a step; its spin grew without end with the usual sub-steps.
TEST(SoftChain, OfALightBodyBetweenHeavyOnesGainsNoEnergy) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double light : {0.01, 0.1}) {
            World world(settings);
            BodyId last = world.add(support::hook({0, 5, 0}));
            for (const double mass : {light, 10.0}) {
                const double x = mass == light ? 0.3 : 0.6;
                BodyDef box = support::body(Shape::box({0.2, 0.1, 0.1}), {x, 5, 0}, mass);
                box.collide = false;
                const BodyId next = world.add(box);
                JointDef joint;
                joint.a = last, joint.b = next;
                joint.anchorA = Vec3(x - 0.15, 5, 0) - world.pose(last).position;
                joint.anchorB = {-0.15, 0, 0};
                joint.spring.hz = 20.0, joint.spring.damping = 0.0;
                world.add(joint);
                last = next;
            }
            const double start = world.energy().total();
            for (int i = 0; i < 900; ++i) {
                ASSERT_TRUE(world.step(support::kStep));
                ASSERT_LT(world.energy().total(), start + 5.0) << light << ", step " << i;  // of 490 J
            }
        }
}

/// Links of 1 kg and 20 cm, or rods between balls of 1 kg, from a post to a bob or to another post.
struct Slack {
    World world;
    BodyId last;
    Vec3 anchor = Vec3::Zero(), end = Vec3::Zero();
    JointType type;

    Slack(const Settings& settings, JointType joints) : world(settings), type(joints) {
        last = world.add(support::hook());
    }
    BodyId add(BodyDef def, const Vec3& at, const Vec3& anchorA, const Vec3& anchorB) {
        def.collide = false, def.pose.position = at;
        const BodyId next = world.add(def);
        join(next, anchorA, anchorB);
        return next;
    }
    void join(BodyId next, const Vec3& anchorA, const Vec3& anchorB) {
        JointDef joint;
        joint.type = type, joint.a = last, joint.b = next, joint.axis = Vec3::UnitZ();
        if (type == JointType::distance) joint.length = 0.2;
        else joint.anchorA = anchorA, joint.anchorB = anchorB;
        world.add(joint);
        last = next;
    }
    void addLink(const Vec3& along, double mass = 1.0) {
        const Vec3 before = end;
        end += 0.2 * along;
        if (type == JointType::distance) {
            add(body(Shape::sphere(0.05), end, mass), end, anchor, Vec3::Zero());
            return;
        }
        BodyDef link = body(Shape::box({0.2, 0.04, 0.04}), end, mass);
        link.pose.rotation = Quat::FromTwoVectors(Vec3::UnitX(), along);
        add(link, 0.5 * (before + end), anchor, {-0.1, 0, 0});
        anchor = {0.1, 0, 0};
    }
    /// The worst gap (m), and the largest gain of energy (J).
    std::pair<double, double> watch(int steps) {
        const double start = world.energy().total();
        double gap = 0.0, gain = 0.0;
        for (int i = 0; i < steps; ++i) {
            world.step(kStep);
            gap = std::max(gap, world.errors().separation), gain = std::max(gain, world.energy().total() - start);
        }
        return {gap, gain};
    }
};

// Released above its hook, it falls freely and snaps taut: its links could not be stopped, and it grew by 36 m.
TEST(SlackChain, OfLightLinksHoldsAHeavyBobThatSnapsItTaut) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double degrees : {100.0, 120.0, 175.0})
            for (const double mass : {100.0, 1000.0}) {
                Slack chain(settings, JointType::ball);
                const double angle = radians(degrees);
                const Vec3 along(std::sin(angle), -std::cos(angle), 0);
                for (int i = 0; i < 40; ++i) chain.addLink(along);
                const BodyDef bob = body(Shape::sphere(0.1), {0, 0, 0}, mass);
                chain.add(bob, chain.end + 0.1 * along, chain.anchor, -0.1 * along);
                const auto [gap, gain] = chain.watch(360);
                EXPECT_LT(gap, 1e-3) << degrees << " degrees, " << mass << " kg";
                EXPECT_LT(gain, 0.01 * mass * kGravity * 16.0) << degrees << " degrees, " << mass << " kg";
            }
}

// Its middle is as heavy as a thousand links, starts above the posts and falls between them.
TEST(SlackChain, BetweenTwoPostsHoldsAHeavyMiddle) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const JointType type : {JointType::ball, JointType::hinge, JointType::distance})
            for (const double slack : {0.02, 0.2}) {
                constexpr int kLinks = 20;
                Slack chain(settings, type);
                const double half = 0.1 * kLinks / (1.0 + slack);
                const double rise = std::sqrt(0.01 * kLinks * kLinks - half * half);
                const Vec3 along = Vec3(half, rise, 0).normalized();
                for (int i = 0; i < kLinks; ++i) {
                    if (type == JointType::distance && i == kLinks - 1) continue;  // from the last ball to the post
                    const double up = i < kLinks / 2 ? along.y() : -along.y();
                    chain.addLink({along.x(), up, 0}, i == kLinks / 2 ? 1000.0 : 1.0);
                }
                BodyDef post = support::hook({2.0 * half, 0, 0});
                chain.join(chain.world.add(post), chain.anchor, Vec3::Zero());
                const auto [gap, gain] = chain.watch(300);
                EXPECT_LT(gap, 2e-3) << static_cast<int>(type) << ", slack " << slack;
                EXPECT_LT(gain, 10.0 * kGravity * 2.0 * rise) << static_cast<int>(type) << ", slack " << slack;
            }
}

}  // namespace
}  // namespace engine
