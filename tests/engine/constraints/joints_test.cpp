// mission 12: for every type J v equals the central difference of C at 100 random states.
#include <gtest/gtest.h>

#include "engine/constraints/joint_constraint.h"
#include "engine/dynamics/rotation.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

class EveryJoint : public testing::TestWithParam<JointType> {};

TEST_P(EveryJoint, JvIsTheDerivativeOfC) {
    support::Random random(20 + static_cast<int>(GetParam()));
    for (int i = 0; i < 100; ++i) {
        Joint joint;
        joint.def.type = GetParam();
        joint.def.anchorA = random.vector(1), joint.def.anchorB = random.vector(1);
        joint.def.length = 0.7;
        joint.axisA = random.vector(1).normalized(), joint.axisB = random.vector(1).normalized();
        joint.turnAtStart = random.rotation();
        const Pose a{random.vector(2), random.rotation()}, b{random.vector(2), random.rotation()};
        const Velocity<double> va{random.vector(2), random.vector(2)};
        const Velocity<double> vb{random.vector(2), random.vector(2)};
        const auto at = [&](double t) {
            return rowsOf(GetParam(),
                          geometryOf(joint, {a.position + t * va.linear,
                                             cayley(t * va.angular, a.rotation)},
                                     {b.position + t * vb.linear,
                                      cayley(t * vb.angular, b.rotation)}));
        };
        const double dt = 1e-5;
        const JointRows<double> now = at(0.0), before = at(-dt), after = at(dt);
        for (int k = 0; k < now.count; ++k) {
            const double slope = (after.error[k] - before.error[k]) / (2 * dt);
            EXPECT_NEAR(velocityAlong(now.j[k], va, vb), slope,
                        1e-6 * larger(1.0, std::abs(slope)));
        }
    }
}

TEST_P(EveryJoint, HasNoErrorWhereItWasMade) {
    support::Random random(30);
    World world;
    const BodyId a = world.add(support::body(Shape::sphere(0.5), random.vector(1)));
    BodyDef other = support::body(Shape::sphere(0.5), random.vector(1));
    other.pose.rotation = random.rotation();
    const BodyId b = world.add(other);
    const JointId id = GetParam() == JointType::distance
                           ? support::rod(world, a, b)
                           : support::join(world, GetParam(), a, b, {0.1, 0.2, 0.3});
    EXPECT_LT(world.joint(id).separation, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(All, EveryJoint,
                         testing::Values(JointType::ball, JointType::distance, JointType::hinge,
                                         JointType::weld));

TEST(Joints, CountTheirRows) {
    const auto count = [](JointType type) {
        return rowsOf(type, geometryOf(Joint{}, Pose{}, Pose{})).count;
    };
    for (const JointType type :
         {JointType::ball, JointType::distance, JointType::hinge, JointType::weld})
        EXPECT_EQ(count(type), rowCount(type));
    EXPECT_EQ(count(JointType::ball), 3);
    EXPECT_EQ(count(JointType::distance), 1);
    EXPECT_EQ(count(JointType::hinge), 5);
    EXPECT_EQ(count(JointType::weld), 6);
}

// mission 14: p = (3,4,0), p0 = 0, l = 4: C = 1
TEST(DistanceJoint, IsTheDistanceLessTheLength) {
    Joint joint;
    joint.def.type = JointType::distance;
    joint.def.length = 4.0;
    const JointRows<double> rows =
        rowsOf(JointType::distance, geometryOf(joint, {}, {{3, 4, 0}, Quat::Identity()}));
    EXPECT_NEAR(rows.error[0], 1.0, 1e-15);
    EXPECT_LT((rows.j[0].linear - Vec3(0.6, 0.8, 0)).norm(), 1e-15);  // unit(p - p0)
}

// and with r = (0, -0.5, 0), I = 0.4, m = 2, v = (1, 2, 3), w = (0, 0, 1): the joint's own row
TEST(DistanceJoint, GivesTheSeedsImpulseAtAnArm) {
    Joint joint;
    joint.def.type = JointType::distance;
    joint.def.length = 4.0;
    joint.def.anchorB = {0, -0.5, 0};
    const JointRows<double> rows =
        rowsOf(JointType::distance, geometryOf(joint, {}, {{3, 4.5, 0}, Quat::Identity()}));
    const Row<double> row = makeRow<double>(rows.j[0], {}, {0.5, Mat3::Identity() / 0.4});
    EXPECT_NEAR(rows.error[0], 1.0, 1e-15);
    EXPECT_NEAR(row.k, 0.725, 1e-15);
    EXPECT_NEAR(correctiveImpulse<double>(row, 0.0, {}, {{1, 2, 3}, {0, 0, 1}}), -3.4482759, 5e-8);
}

}  // namespace
}  // namespace engine
