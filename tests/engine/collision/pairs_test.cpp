// Every pair of shapes compared with an independent measure: the smallest distance from the core.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "engine/collision/collide.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

/// Signed distance of a point to a shape; negative inside (a box's inside is the nearest face).
double distanceTo(const Shape& s, const Pose& pose, const Vec3& world) {
    const Vec3 p = pose.toLocal(world);
    switch (s.type) {
        case ShapeType::sphere: return p.norm() - s.radius;
        case ShapeType::capsule:
            return (p - Vec3(0, clamped(p.y(), -s.halfLength, s.halfLength), 0)).norm() - s.radius;
        case ShapeType::plane: return s.normal.dot(p);
        default: break;  // a box
    }
    const Vec3 d = p.cwiseAbs() - s.halfSize;
    const Vec3 outside = d.cwiseMax(0.0);
    return outside.norm() + smaller(d.maxCoeff(), 0.0);
}

/// Smallest distance from points of the core of a round shape to a convex one, less the radius: the
/// distance is convex along the core, so every third of it without the smallest can be left out.
double leastGap(const Shape& round, const Pose& pose, const Shape& other, const Pose& otherPose) {
    const auto at = [&](double y) { return distanceTo(other, otherPose, pose.toWorld({0, y, 0})); };
    double low = -round.halfLength, high = round.halfLength;
    while (high - low > 1e-7) {
        const double third = (high - low) / 3.0;
        if (at(low + third) < at(high - third))
            high -= third;
        else
            low += third;
    }
    return at(0.5 * (low + high)) - round.radius;
}

struct RoundPair {
    Shape round, other;
};

class RoundPairs : public testing::TestWithParam<int> {
protected:
    static RoundPair pair(int i) {
        const Shape ball = Shape::sphere(0.4), pill = Shape::capsule(0.25, 1.3);
        const Shape box = Shape::box({1.0, 0.7, 1.4}), plane = Shape::plane({0, 1, 0});
        const RoundPair all[] = {{ball, ball}, {ball, box}, {ball, pill}, {ball, plane},
                                 {pill, pill}, {pill, box}, {pill, plane}};
        return all[i];
    }
};

TEST_P(RoundPairs, TheDeepestPointIsTheGap) {
    const RoundPair p = pair(GetParam());
    support::Random random(10 + GetParam());
    int touching = 0;
    for (int i = 0; i < 2000; ++i) {
        const Pose a{random.vector(1.2), random.rotation()};
        const Pose b{Vec3::Zero(), p.other.type == ShapeType::plane ? Quat::Identity()
                                                                    : random.rotation()};
        const double gap = leastGap(p.round, a, p.other, b);
        const bool coreOutside = gap > -p.round.radius + 1e-3;
        const Manifold m = collide(p.round, a, p.other, b, 0.05);
        if (gap > 0.051) {
            EXPECT_EQ(m.count, 0);
        }
        if (gap > 0.049) continue;
        ASSERT_GT(m.count, 0);
        double deepest = 1e9;
        for (int k = 0; k < m.count; ++k) {
            const Vec3 between = m.points[k].onB - m.points[k].onA;
            EXPECT_LT(between.cross(m.normal).norm(), 1e-9);
            deepest = smaller(deepest, between.dot(m.normal));
        }
        EXPECT_NEAR(m.normal.norm(), 1.0, 1e-12);
        if (!coreOutside) continue;  // inside, 'deepest' depends on the direction chosen
        ++touching;
        EXPECT_NEAR(deepest, gap, 1e-4);
    }
    EXPECT_GT(touching, 80);
}

INSTANTIATE_TEST_SUITE_P(All, RoundPairs, testing::Range(0, 7));

TEST(BoxPlane, GivesTheFourLowestCorners) {
    const Manifold m = collide(Shape::box({2, 1, 1}), {{0, 0.49, 0}, Quat::Identity()},
                               Shape::plane({0, 1, 0}), {}, 0.02);
    ASSERT_EQ(m.count, 4);
    EXPECT_EQ(m.normal, Vec3(0, -1, 0));  // from the box to the plane
    for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(m.points[i].onA.y(), -0.01, 1e-15);
        EXPECT_NEAR(m.points[i].onB.y(), 0.0, 1e-15);
    }
}

TEST(SpherePlane, MayBeAnywhere) {
    for (const double height : {-7.0, 0.0, 3.0}) {
        const Manifold m = collide(Shape::sphere(0.5), {{2, height + 0.49, 1}, Quat::Identity()},
                                   Shape::plane({0, 1, 0}), {{-4, height, 6}, Quat::Identity()}, 0.02);
        ASSERT_EQ(m.count, 1) << height;
        EXPECT_NEAR(m.separation(0), -0.01, 1e-14) << height;
        EXPECT_NEAR(m.points[0].onB.y(), height, 1e-14);
    }
}

TEST(CapsuleBox, LyingOnAFaceGivesTwoPoints) {
    const Pose lying{{0, 0.5 + 0.25, 0}, turnAbout(Vec3::UnitZ(), radians(90))};
    const Manifold m =
        collide(Shape::box({4, 1, 4}), {}, Shape::capsule(0.25, 1.5), lying, 0.02);
    ASSERT_EQ(m.count, 2);
    EXPECT_NEAR(std::abs(m.points[0].onA.x() - m.points[1].onA.x()), 1.0, 1e-9);
}

TEST(CapsuleBox, OverhangingIsHeldAtTheEdge) {
    const Pose lying{{2.0, 0.5 + 0.25, 0}, turnAbout(Vec3::UnitZ(), radians(90))};
    const Manifold m =
        collide(Shape::box({4, 1, 4}), {}, Shape::capsule(0.25, 1.5), lying, 0.02);
    ASSERT_EQ(m.count, 2);
    EXPECT_NEAR(larger(m.points[0].onA.x(), m.points[1].onA.x()), 2.0, 1e-9);
}

TEST(CapsuleCapsule, SideBySideGivesTwoPoints) {
    const Shape pill = Shape::capsule(0.25, 1.5);
    const Manifold m = collide(pill, {}, pill, {{0.5, 0.3, 0}, Quat::Identity()}, 0.02);
    ASSERT_EQ(m.count, 2);
    EXPECT_LT((m.normal - Vec3::UnitX()).norm(), 1e-6);
}

// A point that comes anew starts without the impulse of another place.
TEST(CapsuleCapsule, EndsAreOtherFeaturesThanTheCrossing) {
    const Shape pill = Shape::capsule(0.25, 1.5);
    const Pose beside = support::at({0.5, 0, 0});
    const Quat across = turnAbout(Vec3::UnitX(), 0.5);
    const Manifold ends = collide(pill, {}, pill, beside, 0.02);
    const Manifold crossing = collide(pill, {}, pill, {beside.position, across}, 0.02);
    ASSERT_EQ(ends.count, 2);
    ASSERT_EQ(crossing.count, 1);
    EXPECT_NE(ends.points[0].feature, ends.points[1].feature);
    for (const int end : {0, 1}) EXPECT_NE(ends.points[end].feature, crossing.points[0].feature);
}

TEST(Concentric, ShapesGetSomeNormalAndNoNaN) {
    for (const Shape& a : {Shape::sphere(0.5), Shape::box({1, 1, 1}), Shape::capsule(0.3, 1.2)})
        for (const Shape& b : {Shape::sphere(0.5), Shape::box({1, 1, 1}), Shape::capsule(0.3, 1.2)}) {
            const Manifold m = collide(a, {}, b, {}, 0.02);
            ASSERT_GT(m.count, 0);
            EXPECT_NEAR(m.normal.norm(), 1.0, 1e-12);
            for (int i = 0; i < m.count; ++i) EXPECT_TRUE(m.points[i].onB.allFinite());
        }
}

}  // namespace
}  // namespace engine
