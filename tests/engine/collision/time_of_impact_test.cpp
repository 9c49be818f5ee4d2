#include "engine/collision/time_of_impact.h"

#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "engine/collision/collide.h"
#include "engine/collision/contacts.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::kStep;

Motion moving(const Shape& shape, const Vec3& at, const Vec3& velocity,
              const Vec3& spin = Vec3::Zero()) {
    Bodies bodies;
    BodyDef def = support::body(shape, at);
    def.velocity = velocity, def.spin = spin;
    addBody(bodies, def, bodies.count());
    return motionOf(bodies, 0, kStep);
}

/// The time when the two first overlap by a tenth of a millimetre, by marching; more than a step: never
/// within it.
double firstOverlap(const Shape& sa, const Motion& a, const Shape& sb, const Motion& b) {
    constexpr int kParts = 800;
    for (int k = 0; k <= kParts; ++k) {
        const double t = k * kStep / kParts;
        if (collide(sa, a.at(t), sb, b.at(t), -1e-4).count > 0) return t;
    }
    return 1.0;
}

TEST(TimeOfImpact, OfTwoBallsIsTheRootOfAQuadratic) {
    // |d + t v| = r1 + r2
    const Shape ball = Shape::sphere(0.1);
    const Motion a = moving(ball, {0, 0, 0}, {100, 0, 0});
    const Motion b = moving(ball, {2, 0.1, 0}, {-100, 0, 0});
    const Impact impact = timeOfImpact(ball, a, ball, b, kStep);
    ASSERT_TRUE(impact.meets);
    EXPECT_NEAR(impact.time, (2 - std::sqrt(0.04 - 0.01)) / 200, 5e-4 / 150);  // 0.5 mm early
    EXPECT_LE(impact.time, (2 - std::sqrt(0.04 - 0.01)) / 200);
}

TEST(TimeOfImpact, OfTwoBoxesThatDoNotTurnIsExact) {
    const Shape box = Shape::box({1, 1, 1});
    const Motion a = moving(box, {0, 0, 0}, {0, 0, 0});
    const Motion b = moving(box, {1.5, 1.4, 0.2}, {-60, -60, 0});
    const Impact impact = timeOfImpact(box, a, box, b, kStep);
    ASSERT_TRUE(impact.meets);
    EXPECT_NEAR(impact.time, 0.5 / 60, 1e-12);  // x is the last axis to close
}

TEST(TimeOfImpact, ABoxThatPassesBesideDoesNotMeet) {
    const Shape box = Shape::box({1, 1, 1});
    const Motion a = moving(box, {0, 0, 0}, {0, 0, 0});
    const Motion b = moving(box, {1.5, 1.01, 0}, {-300, 0, 0});
    EXPECT_FALSE(timeOfImpact(box, a, box, b, kStep).meets);
}

TEST(TimeOfImpact, OfASpinningRodIsWhenItsTipComesDown) {
    // Level at first, its middle 0.5 m above the floor: the tip is down when sin(w t) = 0.5
    const Shape rod = Shape::box({2, 1e-3, 1e-3}), plane = Shape::plane(Vec3::UnitY());
    const Motion a = moving(rod, {0, 0.5, 0}, {0, 0, 0}, {0, 0, 60});
    Motion floor;
    const Impact impact = timeOfImpact(rod, a, plane, floor, kStep);
    ASSERT_TRUE(impact.meets);
    EXPECT_NEAR(impact.time, kPi / 6 / 60, 3e-5);  // 1 mm at 52 m/s
    EXPECT_LE(impact.time, kPi / 6 / 60);
}

class ImpactOfAnyShapes : public testing::TestWithParam<int> {};  // how many pairs

// Compared with marching in small steps: never later, and none missed.
TEST_P(ImpactOfAnyShapes, IsNeverLate) {
    support::Random random(GetParam() + 7);
    const std::vector<Vec3> needle{{0, -0.8, 0}, {0.1, 0.7, 0}, {-0.1, 0.7, 0}, {0, 0.8, 0.1}};
    const Shape shapes[] = {Shape::sphere(0.2), Shape::box({0.3, 0.5, 0.9}),
                            Shape::capsule(0.1, 1.0), Shape::cylinder(0.5, 0.04),
                            Shape::cone(0.1, 1.2), *Shape::hullOf(needle)};
    int met = 0;
    for (int i = 0; i < GetParam(); ++i) {
        const Shape &sa = shapes[i % 6], &sb = shapes[i / 6 % 6];
        const double speed = i % 5 ? 40.0 : 2.0;  // slow ones turn side by side
        Motion a = moving(sa, random.vector(0.5), random.vector(speed), random.vector(60));
        Motion b = moving(sb, random.vector(0.5) + Vec3(i % 5 ? 1.6 : 0.8, 0, 0),
                          random.vector(speed) - Vec3(i % 5 ? 60 : 2, 0, 0), random.vector(60));
        a.start.rotation = random.rotation(), b.start.rotation = random.rotation();
        const Impact impact = timeOfImpact(sa, a, sb, b, kStep);
        const double first = firstOverlap(sa, a, sb, b);
        if (first <= kStep) {
            EXPECT_TRUE(impact.meets) << i;
            EXPECT_LE(impact.time, first) << i;
            ++met;
        }
    }
    EXPECT_GT(met, GetParam() / 9);
}

INSTANTIATE_TEST_SUITE_P(All, ImpactOfAnyShapes, testing::Values(120, 600));

TEST(TimeOfImpact, OfAPartOnItsWayRoundIsWhenItsCircleGetsThere) {
    // A ball 2 m from the axis it turns about, and beside it, nearer to the axis, a post of equal speed:
    // their courses are parallel, but the circle bends. -2 cos(w t) + 0.1 = -1.85
    const Shape ball = Shape::sphere(0.1), post = Shape::cylinder(0.1, 0.4);
    const Pose place{{-2, 0, 0}, Quat::Identity()};
    Motion a = moving(ball, {0, 0, 0}, {0, 0, 0}, {0, 0, 20});
    a.size = a.reach = 2.1, a.sweep = 42.0;
    const Motion b = moving(post, {-1.75, 0, 0}, {0, -40, 0});
    const Impact impact = timeOfImpact({&ball, 0, false, &place}, a, wholeOf(post), b, kStep);
    const double exact = std::acos(0.975) / 20.0;
    ASSERT_TRUE(impact.meets);
    EXPECT_LE(impact.time, exact);
    EXPECT_NEAR(impact.time, exact, 1e-4);
}

TEST(TimeOfImpact, OfALargeBodyThatTurnsIsNeverLate) {
    support::Random random(11);
    const Shape drum = Shape::box({8, 8, 2}), paddle = Shape::capsule(0.3, 9.0);
    const Shape small[] = {Shape::box({0.3, 0.2, 0.4}), Shape::sphere(0.2), Shape::capsule(0.1, 0.5)};
    int met = 0, slow = 0;
    for (int i = 0; i < 400; ++i) {
        const Shape &large = i % 2 ? drum : paddle, &other = small[i % 3];
        Motion a = moving(large, random.vector(0.2), random.vector(2), random.vector(i % 5 ? 4 : 20));
        a.start.rotation = random.rotation();
        const Vec3 at = a.start.position + 4.0 * random.vector(1.0).normalized();
        // About as fast as the large body at that point, and a little towards or away from it.
        const Vec3 with = a.velocity + a.spin.cross(at - a.start.position);
        Motion b = moving(other, at, with + random.vector(i % 3 ? 1.0 : 12.0), random.vector(10));
        b.start.rotation = random.rotation();
        const Impact impact = timeOfImpact(large, a, other, b, kStep);
        EXPECT_NEAR(wayOf(a, b, kStep), wayOf(b, a, kStep), 1e-12);
        slow += wayOf(a, b, kStep) < 0.25 * kStep * a.sweep ? 1 : 0;
        const double first = firstOverlap(large, a, other, b);
        if (first > kStep) continue;
        EXPECT_TRUE(impact.meets) << i;
        EXPECT_LE(impact.time, first) << i;
        ++met;
    }
    EXPECT_GT(met, 60);
    EXPECT_GT(slow, 60);  // bodies that turn with it do not count as fast
}

TEST(TimeOfImpact, WithinNearIsAsIfItWereExact) {
    support::Random random(12);
    const Shape shapes[] = {Shape::box({0.3, 0.5, 0.9}), Shape::capsule(0.1, 1.0),
                            Shape::cylinder(0.3, 0.7)};
    constexpr double kNear = 0.05;
    int near = 0, far = 0;
    for (int i = 0; i < 600; ++i) {
        const Shape &sa = shapes[i % 3], &sb = shapes[i / 3 % 3];
        Motion a = moving(sa, random.vector(0.5), random.vector(20), random.vector(30));
        Motion b = moving(sb, random.vector(0.5) + Vec3(1.2, 0, 0), random.vector(20), random.vector(30));
        a.start.rotation = random.rotation(), b.start.rotation = random.rotation();
        const Impact exact = timeOfImpact(sa, a, sb, b, kStep);
        const Impact limited = timeOfImpact(sa, a, sb, b, kStep, kNear);
        if (exact.meets || exact.distance <= kNear) {
            EXPECT_EQ(limited.meets, exact.meets) << i;
            EXPECT_EQ(limited.time, exact.time) << i;
            EXPECT_EQ(limited.distance, exact.distance) << i;
            ++near;
        } else {
            EXPECT_FALSE(limited.meets) << i;
            EXPECT_GT(limited.distance, kNear) << i;
            ++far;
        }
    }
    EXPECT_GT(near, 50);
    EXPECT_GT(far, 50);
}

Contact onlyContact(const Bodies& bodies, double margin = 0.02) {
    ContactFinder finder;
    findContacts(bodies, finder, margin, kStep);
    EXPECT_EQ(finder.contacts.size(), 1u);
    return finder.contacts.empty() ? Contact{} : finder.contacts[0];
}

double gapAt(const Bodies& bodies, const Contact& c, int i = 0) {
    return c.normal.dot(bodies.poses[c.b].toWorld(c.points[i].anchorB) -
                        bodies.poses[c.a].toWorld(c.points[i].anchorA));
}

TEST(MovingContact, HasTheNormalOfTheImpact) {
    // A ball flies past the wall's end toward a post: at first the nearest face is not the one it hits.
    Bodies bodies;
    addBody(bodies, support::fixed(Shape::box({0.2, 2, 2})), bodies.count());
    BodyDef ball = support::body(Shape::sphere(0.05), {-2, 1.5, 0});
    ball.velocity = {200, -100, 0};
    addBody(bodies, ball, bodies.count());
    const Contact c = onlyContact(bodies);
    EXPECT_NEAR(c.normal.x(), -1.0, 1e-12);
    EXPECT_NEAR(gapAt(bodies, c), 1.85, 1e-3);  // along x, from face to ball
}

TEST(MovingContact, CountsTheTurnIntoTheWayToGo) {
    Bodies bodies;
    addBody(bodies, support::floorPlane(), bodies.count());
    BodyDef rod = support::body(Shape::box({2, 0.01, 0.01}), {0, 0.5, 0});
    rod.spin = {0, 0, 60};
    addBody(bodies, rod, bodies.count());
    const Contact c = onlyContact(bodies);
    double least = 1e9;
    for (int i = 0; i < c.count; ++i) least = smaller(least, gapAt(bodies, c, i));
    // C = t * 60 rad/s * the arm at the impact, cos 30 degrees
    EXPECT_NEAR(least, kPi / 6 * std::sqrt(0.75), 0.02);
}

TEST(MovingContact, NoneForAPairThatPasses) {
    Bodies bodies;
    addBody(bodies, support::fixed(Shape::box({0.1, 3, 0.1})), bodies.count());
    BodyDef ball = support::body(Shape::sphere(0.05), {-2, 0, 0.4});
    ball.velocity = {200, 0, 0};
    addBody(bodies, ball, bodies.count());
    ContactFinder finder;
    findContacts(bodies, finder, 0.02, kStep);
    EXPECT_TRUE(finder.contacts.empty());
}

TEST(MovingContact, ABodyAboutToBeHitSeesItsNeighbour) {
    Bodies bodies;
    for (const double x : {0.0, 0.5, 0.8})
        addBody(bodies, support::body(Shape::sphere(0.05), {x, 0, 0}), bodies.count());
    ContactFinder calm, hit;
    findContacts(bodies, calm, 0.02, kStep);
    EXPECT_TRUE(calm.contacts.empty());
    bodies.velocities[0].linear = {40, 0, 0};
    findContacts(bodies, hit, 0.02, kStep);
    ASSERT_GE(hit.contacts.size(), 2u);
    EXPECT_EQ(hit.contacts.back().a, 1);
    EXPECT_EQ(hit.contacts.back().b, 2);
}

// Rotation is included: a rod's bounds contain it at any time of the step.
TEST(BroadPhase, SeesWhereASpinningRodWillBe) {
    Bodies bodies;
    BodyDef rod = support::body(Shape::box({2, 0.02, 0.02}), {0, 0, 0});
    rod.spin = {0, 0, 60};
    addBody(bodies, rod, bodies.count());
    addBody(bodies, support::body(Shape::sphere(0.05), {0.6, 0.6, 0}), bodies.count());
    BroadPhase broad;
    broad.update(bodies, 0.02, kStep);
    EXPECT_EQ(broad.pairs().size(), 1u);
}

}  // namespace
}  // namespace engine
