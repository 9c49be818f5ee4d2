#include <gtest/gtest.h>

#include <set>

#include "engine/base/trigonometry.h"
#include "engine/collision/collide.h"
#include "engine/collision/oriented_box.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::at;

const Shape kCube = Shape::box({1, 1, 1});

std::set<int> features(const Manifold& m) {
    std::set<int> result;
    for (int i = 0; i < m.count; ++i) result.insert(m.points[i].feature);
    return result;
}

TEST(BoxBox, AFaceOnAFaceGivesItsFourCorners) {
    const Manifold m = collide(kCube, at({0, 0, 0}), kCube, at({0, 0.99, 0}), 0.02);
    ASSERT_EQ(m.count, 4);
    EXPECT_LT((m.normal - Vec3::UnitY()).norm(), 1e-15);
    for (int i = 0; i < 4; ++i) {
        const Vec3 gap = m.points[i].onB - m.points[i].onA;
        EXPECT_NEAR(gap.dot(m.normal), -0.01, 1e-12);
        EXPECT_NEAR(std::abs(m.points[i].onA.x()), 0.5, 1e-12);
        EXPECT_NEAR(std::abs(m.points[i].onA.z()), 0.5, 1e-12);
    }
    EXPECT_EQ(features(m).size(), 4u);
}

TEST(BoxBox, FeaturesSurviveRoundingAndSmallTurns) {
    support::Random random(5);
    const std::set<int> rest = features(collide(kCube, at({0, 0, 0}), kCube, at({0, 1, 0}), 0.02));
    for (int i = 0; i < 200; ++i) {
        const Vec3 shake = random.vector(1e-5);
        const Quat turn = turnAboutXyz(random.vector(1e-5));
        EXPECT_EQ(features(collide(kCube, at({0, 0, 0}), kCube, at(Vec3(0, 1, 0) + shake, turn),
                                   0.02)),
                  rest);
    }
}

// The larger box has the reference face. Impulses are carried by features: those of one arrangement are none of the
// other's, although the same sides face each other.
TEST(BoxBox, FeaturesKnowWhoseFaceTheReferenceIs) {
    const Quat over = turnAbout(Vec3::UnitX(), radians(180)), tilt = turnAbout(Vec3::UnitZ(), radians(2));
    const Shape wide = Shape::box({4, 1, 4});
    const std::set<int> ofA = features(collide(wide, at({0, 0, 0}), kCube, at({0, 1, 0}, tilt), 0.1));
    const std::set<int> ofB = features(collide(kCube, at({0, 0, 0}, tilt * over), wide, at({0, 1, 0}, over), 0.1));
    ASSERT_EQ(ofA.size(), 4u);
    ASSERT_EQ(ofB.size(), 4u);
    for (const int feature : ofA) EXPECT_FALSE(ofB.contains(feature)) << feature;
}

// Two crossed edges: the distance of two lines at right angles.
TEST(BoxBox, EdgesThatCrossGiveOnePointBetween) {
    const Quat tiltX = turnAbout(Vec3::UnitX(), radians(45));
    const Quat tiltZ = turnAbout(Vec3::UnitZ(), radians(45));
    const double height = std::sqrt(2.0) - 0.01;
    const Manifold m = collide(kCube, at({0, 0, 0}, tiltX), kCube, at({0, height, 0}, tiltZ), 0.02);
    ASSERT_EQ(m.count, 1);
    EXPECT_LT((m.normal - Vec3::UnitY()).norm(), 1e-12);
    EXPECT_NEAR((m.points[0].onB - m.points[0].onA).dot(m.normal), -0.01, 1e-12);
    EXPECT_NEAR(m.points[0].onA.y(), std::sqrt(0.5), 1e-9);
}

TEST(BoxBox, ATurnedFaceKeepsFourPointsThatHoldTheCentre) {
    const Quat turn = turnAbout(Vec3::UnitY(), radians(45));  // the overlap is an octagon
    const Manifold m = collide(kCube, at({0, 0, 0}), kCube, at({0, 1, 0}, turn), 0.02);
    ASSERT_EQ(m.count, 4);
    Vec3 middle = Vec3::Zero();
    for (int i = 0; i < 4; ++i) middle += 0.25 * m.points[i].onA;
    EXPECT_LT(std::hypot(middle.x(), middle.z()), 0.15);
    for (int i = 0; i < 4; ++i) EXPECT_GT(std::hypot(m.points[i].onA.x(), m.points[i].onA.z()), 0.5);
}

TEST(BoxBox, ApartByMoreThanTheMarginGivesNothing) {
    EXPECT_EQ(collide(kCube, at({0, 0, 0}), kCube, at({0, 1.021, 0}), 0.02).count, 0);
    EXPECT_EQ(collide(kCube, at({0, 0, 0}), kCube, at({0, 1.019, 0}), 0.02).count, 4);
    EXPECT_EQ(collide(kCube, at({0, 0, 0}), kCube, at({1.2, 1.2, 0}), 0.02).count, 0);
}

// A corner half a millimetre outside is kept; its neighbour a hair farther is not. The line through
// both meets the cutting plane kilometres away, and no point may be there.
TEST(BoxBox, PointsStayOnTheBoxesHoweverTheyGrazeEachOther) {
    support::Random random(7);
    for (int i = 0; i < 20000; ++i) {
        const Quat turn = turnAboutXyz(random.vector(2e-3));
        const Vec3 beside(1.0 + random.number(-1e-3, 1e-3), random.number(-1e-3, 1e-3),
                          random.number(-1e-3, 1e-3));
        const Manifold m = collide(kCube, at({0, 0, 0}), kCube, at(beside, turn), 0.02);
        for (int k = 0; k < m.count; ++k) ASSERT_LT(m.points[k].onA.norm(), 1.0) << i;
    }
}

// For all poses: the normal is a unit vector from a to b, no point is deeper than the boxes reach, and
// exchanging the boxes gives the same depths.
TEST(BoxBox, IsSaneForRandomPoses) {
    support::Random random(6);
    int touching = 0;
    for (int i = 0; i < 3000; ++i) {
        const Shape a = Shape::box(Vec3::Constant(0.4) + random.vector(0.3));
        const Shape b = Shape::box(Vec3::Constant(0.4) + random.vector(0.3));
        const Pose poseA = at(Vec3::Zero(), random.rotation());
        const Pose poseB = at(random.vector(0.5), random.rotation());
        const Manifold m = collide(a, poseA, b, poseB, 0.02);
        const Manifold back = collide(b, poseB, a, poseA, 0.02);
        EXPECT_EQ(m.count > 0, back.count > 0);
        if (m.count == 0) continue;
        ++touching;
        EXPECT_NEAR(m.normal.norm(), 1.0, 1e-12);
        EXPECT_GT(m.normal.dot(poseB.position - poseA.position), -1e-9);
        double deepest = 0.0, deepestBack = 0.0;
        for (int k = 0; k < m.count; ++k) {
            const Vec3 gap = m.points[k].onB - m.points[k].onA;
            EXPECT_LE(gap.dot(m.normal), 0.02 + 1e-12);
            EXPECT_LT(gap.cross(m.normal).norm(), 1e-9);
            deepest = smaller(deepest, gap.dot(m.normal));
        }
        for (int k = 0; k < back.count; ++k)
            deepestBack = smaller(
                deepestBack, (back.points[k].onB - back.points[k].onA).dot(back.normal));
        EXPECT_NEAR(deepest, deepestBack, 3e-3);  // the bonuses of axes may change the choice
    }
    EXPECT_GT(touching, 1000);
}

TEST(BoxBox, NoAxisOfEdgesIsLeftOutThatMatters) {
    support::Random random(11);
    int leftOut = 0, kept = 0;
    for (int n = 0; n < 2000; ++n) {
        const OrientedBox a(Shape::box(Vec3::Constant(0.4) + random.vector(0.3)), at(Vec3::Zero(), random.rotation()));
        const Pose placed = at(random.vector(0.8), random.rotation());
        const OrientedBox b(Shape::box(Vec3::Constant(0.4) + random.vector(0.3)), placed);
        const double least = random.number(-0.3, 0.1);
        const EdgeAxes edges(a, b);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const Vec3 axis = a.axes.col(i).cross(b.axes.col(j)).normalized();
                const double apart = std::abs(axis.dot(b.centre - a.centre)) - a.extent(axis) - b.extent(axis);
                const bool may = edges.mayExceed(least, i, j);
                EXPECT_TRUE(may || (apart <= least && apart <= 0.0)) << n << ": " << i << ", " << j;
                (may ? kept : leftOut) += 1;
            }
    }
    EXPECT_GT(leftOut, 6000);
    EXPECT_GT(kept, 4000);
}

}  // namespace
}  // namespace engine
