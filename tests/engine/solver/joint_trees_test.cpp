#include "engine/solver/joint_trees.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "engine/solver/block_factors.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

/// Joints between random bodies; body 0 is fixed.
struct Jointed {
    Bodies bodies;
    std::vector<Joint> joints;
    std::vector<JointConstraint> list;
    JointTrees trees;
    support::Random random;

    Jointed(int count, std::uint64_t seed) : random(seed) {
        addBody(bodies, support::hook(), bodies.count());
        for (int i = 1; i < count; ++i) {
            const Vec3 moments = random.vector(1).cwiseAbs() + Vec3::Constant(1.0);
            BodyDef def = support::body(Shape::sphere(0.5), random.vector(3), random.number(0.3, 9));
            def.inertia = Mat3(moments.asDiagonal());
            def.pose.rotation = random.rotation();
            def.velocity = random.vector(3), def.spin = random.vector(3);
            addBody(bodies, def, bodies.count());
        }
    }
    /// The anchors coincide; a rod has its present length.
    Joint& connect(int a, int b, JointType type = JointType::ball) {
        Joint joint;
        joint.def.type = type;
        joint.def.a = {a}, joint.def.b = {b};
        const Vec3 at = random.vector(3), axis = random.vector(1).normalized();
        const Vec3 end = at + (type == JointType::distance ? random.vector(1) : Vec3(0, 0, 0));
        joint.def.anchorA = bodies.poses[a].toLocal(at);
        joint.def.anchorB = bodies.poses[b].toLocal(end);
        joint.def.length = (end - at).norm();
        joint.axisA = bodies.poses[a].rotation.conjugate() * axis;
        joint.axisB = bodies.poses[b].rotation.conjugate() * axis;
        joint.turnAtStart = bodies.poses[a].rotation.conjugate() * bodies.poses[b].rotation;
        Vec3 other;
        tangents(joint.axisA, joint.axis2A, other);
        joints.push_back(joint);
        return joints.back();
    }
    /// A sixDof; `locked`: one bit per coordinate.
    void connectLocked(int a, int b, unsigned locked) {
        Joint& joint = connect(a, b, JointType::sixDof);
        for (int i = 0; i < 6; ++i) joint.def.free[i].locked = locked >> i & 1u;
    }
    void disturb(int i, double size) {
        bodies.poses[i].position += random.vector(size);
        const Vec3 turn = random.vector(size);
        const Quat small(1.0, turn.x(), turn.y(), turn.z());
        bodies.poses[i].rotation = (small * bodies.poses[i].rotation).normalized();
        updateInverseInertia(bodies, i);
    }
    void build() {
        list.clear();
        for (const Joint& joint : joints) {
            JointConstraint c;
            c.a = joint.def.a.index, c.b = joint.def.b.index;
            c.joint = static_cast<int>(list.size());
            c.count = rowCount(joint.def);
            c.treeRows = treeRowsOf(joint.def);
            list.push_back(c);
        }
        trees.build(list, joints, bodies.inverseMasses);
        trees.prepare(0, joints, bodies);
    }
    Correction solve() {
        Correction correction;
        trees.solveVelocities(0, bodies.velocities, correction);
        return correction;
    }
    JointRows rows(const Joint& joint) const {
        return rowsOf(joint.def.type, geometryOf(joint, bodies.poses[joint.def.a.index],
                                                 bodies.poses[joint.def.b.index]));
    }
    /// For the joints in trees, by the rows of engine/constraints.
    double worst(bool ofError) const {
        double most = 0.0;
        for (std::size_t k = 0; k < joints.size(); ++k) {
            const JointRows r = rows(joints[k]);
            const JointDef& def = joints[k].def;
            for (int i = 0; i < r.count && list[k].inTree; ++i)
                most = larger(most, std::abs(ofError ? r.error[i]
                                                     : velocityAlong(r.j[i],
                                                                     bodies.velocities[def.a.index],
                                                                     bodies.velocities[def.b.index])));
        }
        return most;
    }
    double worstVelocity() const { return worst(false); }
};

class EveryType : public testing::TestWithParam<JointType> {};

TEST_P(EveryType, OneSolveSatisfiesAllJoints) {
    Jointed j(60, 1);
    for (int i = 1; i < 60; ++i) j.connect(static_cast<int>(j.random.number(0, i)), i, GetParam());
    j.build();
    EXPECT_EQ(j.trees.order().size(), 59u);
    EXPECT_TRUE(j.trees.isExact(0));
    EXPECT_GT(j.worstVelocity(), 1.0);
    j.solve();
    EXPECT_LT(j.worstVelocity(), 1e-8);  // sixty welded bodies are one, with arms of many metres
}
INSTANTIATE_TEST_SUITE_P(Types, EveryType,
                         testing::Values(JointType::ball, JointType::distance, JointType::hinge,
                                         JointType::weld));

// Joints with fewer rows than their tree leave the last ones empty.
TEST(JointTrees, MayMixAllTypes) {
    const JointType types[] = {JointType::ball, JointType::distance, JointType::hinge,
                               JointType::weld};
    for (const int kinds : {2, 3, 4}) {
        Jointed j(40, 7);
        for (int i = 1; i < 40; ++i)
            j.connect(static_cast<int>(j.random.number(0, i)), i, types[i % kinds]);
        j.build();
        j.solve();
        EXPECT_LT(j.worstVelocity(), 1e-10) << kinds;
    }
}

// Whatever of a sixDof is locked, alone in a chain and among hinges: velocities and errors of its rows.
TEST(JointTrees, HoldWhatIsLockedOfSixDegrees) {
    for (unsigned locked = 1; locked < 64; ++locked) {
        Jointed j(12, 5);
        for (int i = 1; i < 12; ++i)
            if (i % 3 == 0)
                j.connect(i - 1, i, JointType::hinge);
            else
                j.connectLocked(i / 2, i, locked);
        j.build();
        EXPECT_TRUE(j.trees.isExact(0)) << locked;
        EXPECT_GT(j.worstVelocity(), 0.1) << locked;
        j.solve();
        EXPECT_LT(j.worstVelocity(), 1e-5) << locked;  // arms of many metres
        for (int i = 1; i < 12; ++i) j.disturb(i, 1e-4);
        j.build();
        EXPECT_GT(j.worst(true), 1e-5) << locked;
        j.trees.nudge(0, {0.2}, j.joints, j.bodies);
        EXPECT_LT(j.worst(true), 1e-6) << locked;
    }
}

TEST(JointTrees, AgreeWithTheDenseSystem) {
    Jointed j(6, 2);
    for (int i = 1; i < 6; ++i) j.connect(i / 2, i, i % 2 ? JointType::hinge : JointType::distance);
    j.build();
    const int rows = 3 * 5 + 2 * 1;
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(rows, 36);
    Eigen::VectorXd rhs(rows);
    int r = 0;
    for (const Joint& joint : j.joints) {
        const JointRows made = j.rows(joint);
        const int a = joint.def.a.index, b = joint.def.b.index;
        for (int i = 0; i < made.count; ++i, ++r) {
            jacobian.row(r).segment<3>(6 * a) -= made.j[i].linear.transpose();
            jacobian.row(r).segment<3>(6 * a + 3) += made.j[i].angularA.transpose();
            jacobian.row(r).segment<3>(6 * b) += made.j[i].linear.transpose();
            jacobian.row(r).segment<3>(6 * b + 3) += made.j[i].angularB.transpose();
            rhs[r] = -velocityAlong(made.j[i], j.bodies.velocities[a], j.bodies.velocities[b]);
        }
    }
    Eigen::MatrixXd massInverse = Eigen::MatrixXd::Zero(36, 36);
    for (int i = 0; i < 6; ++i) {
        massInverse.block<3, 3>(6 * i, 6 * i) =
            j.bodies.inverseMasses[i].linear * Mat3::Identity();
        massInverse.block<3, 3>(6 * i + 3, 6 * i + 3) = j.bodies.inverseMasses[i].angular;
    }
    const Eigen::VectorXd expected =
        (jacobian * massInverse * jacobian.transpose()).eval().ldlt().solve(rhs);
    j.solve();
    j.trees.report(j.joints, 1.0);
    r = 0;
    for (const Joint& joint : j.joints)
        for (int i = 0; i < rowCount(joint.def.type); ++i)
            EXPECT_NEAR(joint.lambda[i], expected[r++], 1e-9);
}

// C = 0 to first order: the rest of a small error is its square.
TEST_P(EveryType, ANudgePutsAllErrorsRight) {
    Jointed j(30, 6);
    for (int i = 1; i < 30; ++i) j.connect(static_cast<int>(j.random.number(0, i)), i, GetParam());
    for (int i = 1; i < 30; ++i) j.disturb(i, 1e-4);
    j.build();
    EXPECT_GT(j.worst(true), 1e-5);
    const std::vector<Velocity> before = j.bodies.velocities;
    j.trees.nudge(0, {0.2}, j.joints, j.bodies);
    EXPECT_LT(j.worst(true), 1e-6);
    for (int i = 1; i < 30; ++i) {
        EXPECT_EQ(j.bodies.velocities[i].linear, before[i].linear);
    }
}

TEST(JointTrees, SolveARingAtOnce) {
    Jointed j(11, 3);
    for (int i = 1; i < 11; ++i) j.connect(i, i % 10 + 1);
    j.build();
    EXPECT_TRUE(j.trees.isExact(0));
    EXPECT_EQ(j.trees.whole().size(), 10u);
    j.solve();
    EXPECT_LT(j.worstVelocity(), 1e-9);
}

// A second joint between two bodies of a ring, or one that must be swept: the last joint is in a second
// forest, and neither tree is whole.
TEST(JointTrees, LeaveTheLastJointOfOtherRingsToASecondForest) {
    for (const JointType type : {JointType::ball, JointType::axis}) {
        Jointed j(11, 3);
        for (int i = 1; i < 11; ++i) j.connect(i, i % 10 + 1);
        j.connect(1, 2, type);
        j.build();
        EXPECT_FALSE(j.trees.isExact(0));
        EXPECT_TRUE(j.trees.whole().empty());
    }
}

// A net of six by six knots has 25 loops.
TEST(JointTrees, LeaveTheLoopsOfANetToOtherForests) {
    constexpr int kSide = 6;
    Jointed j(kSide * kSide + 1, 3);
    for (int i = 0; i < kSide * kSide; ++i) {
        if (i % kSide + 1 < kSide) j.connect(i + 1, i + 2);
        if (i + kSide < kSide * kSide) j.connect(i + 1, i + kSide + 1);
    }
    j.build();
    EXPECT_EQ(j.trees.order().size(), 60u);
    EXPECT_FALSE(j.trees.isExact(0));
    EXPECT_TRUE(j.trees.whole().empty());
}

TEST(JointTrees, LeaveSoftJointsToTheSweep) {
    Jointed j(3, 8);
    j.connect(0, 1);
    j.connect(1, 2);
    j.build();
    j.list[1].spring.hz = 1.0;
    j.trees.build(j.list, j.joints, j.bodies.inverseMasses);
    EXPECT_TRUE(j.list[0].inTree);
    EXPECT_FALSE(j.list[1].inTree);
    EXPECT_EQ(j.trees.whole().size(), 1u);
}

// A chain costs blocks linear in its length: no joint is coupled with more than two others.
TEST(JointTrees, AChainHoldsFixedEndsToo) {
    Jointed j(40, 4);
    for (int i = 1; i < 40; ++i) j.connect(i - 1, i);
    j.connect(39, 0);
    j.build();
    j.solve();
    EXPECT_EQ(j.trees.order().size(), 40u);
    EXPECT_LT(j.worstVelocity(), 1e-10);
    const std::vector<ForestPlan> plans = planForests(j.list, j.bodies.inverseMasses);
    for (const ForestPlan::Place& place : plans.at(0).places) EXPECT_LE(place.later.size(), 1u);
    // Eliminated from both ends.
    EXPECT_EQ(plans[0].places[0].joint, 0);
    EXPECT_EQ(plans[0].places[1].joint, 39);
    EXPECT_EQ(plans[0].places[2].joint, 1);
}

// All joints of a body couple with each other, so a forest has at most sixteen of one.
TEST(JointTrees, TakeSixteenJointsOfABodyAndLeaveTheRestToTheNextForest) {
    Jointed j(20, 3);
    for (int i = 2; i < 20; ++i) j.connect(1, i);
    j.build();
    const std::vector<ForestPlan> plans = planForests(j.list, j.bodies.inverseMasses);
    ASSERT_EQ(plans.size(), 2u);
    EXPECT_EQ(plans[0].places.size(), 16u);
    EXPECT_EQ(plans[1].places.size(), 2u);
}

// Parallel hinges between two fixed ends constrain three directions twice, with contradicting targets. A
// single joint takes some 50 N s; those that yield by 1 % take at most a hundred times as much.
TEST(JointTrees, ParallelHingesBetweenTwoBanksStayFinite) {
    for (const double askew : {0.0, 1e-9, 1e-6, 1e-4, 1e-2}) {
        Jointed j(20, 9);
        for (int i = 0; i < 20; ++i) {
            Joint& joint = j.connect(i, (i + 1) % 20, JointType::hinge);
            const Vec3 axis = (Vec3::UnitZ() + j.random.vector(askew)).normalized();
            joint.axisA = j.bodies.poses[i].rotation.conjugate() * axis;
            joint.axisB = j.bodies.poses[(i + 1) % 20].rotation.conjugate() * axis;
        }
        j.build();
        EXPECT_EQ(j.trees.order().size(), 20u);
        j.solve();
        for (int i = 1; i < 20; ++i)
            EXPECT_LT(j.bodies.velocities[i].linear.norm(), 500.0) << askew;
        j.trees.report(j.joints, 1.0);
        for (const Joint& joint : j.joints) EXPECT_LT(joint.force.norm(), 5000.0) << askew;
    }
}

// The same joint twice: the second depends on the first. And two joints that contradict each other.
TEST(JointTrees, RedundantRowsGetNoImpulseAndContradictionsNoInfinity) {
    Jointed j(2, 5);
    j.connect(0, 1);
    j.joints.push_back(j.joints[0]);
    j.joints[1].def.anchorA += Vec3(0.1, 0, 0);
    j.build();
    j.trees.begin(0, 0.0, j.bodies.velocities);
    j.trees.setBiasRate(60.0);
    j.solve();
    j.trees.report(j.joints, 1.0);
    for (const Joint& joint : j.joints) EXPECT_LT(joint.force.norm(), 1000.0);
    EXPECT_LT(j.bodies.velocities[1].linear.norm(), 100.0);
}

// With nothing else in the world, there is only one sweep.
TEST(JointTrees, GiveTheDirectSolutionInOneSweep) {
    Settings settings = Settings::steady();
    settings.compareExact = true;
    World world(settings);
    BodyId last = world.add(support::hook());
    for (int i = 0; i < 8; ++i) {
        const BodyId next = world.add(support::body(Shape::box({1, 0.2, 0.3}), {i + 0.5, 0, 0}));
        const JointType type = i % 2 ? JointType::hinge : JointType::ball;
        support::join(world, type, last, next, {1.0 * i, 0, 0});
        last = next;
    }
    support::run(world, 30);
    EXPECT_EQ(static_cast<int>(world.report().sweeps.size()), world.report().substeps);
    for (const SweepReport& sweep : world.report().sweeps) {
        EXPECT_GE(sweep.distance, 0.0);
        EXPECT_LT(sweep.distance, 1e-9);
    }
}

// A force field gets velocities that satisfy the joints, in every sub-step.
TEST(JointTrees, ProjectVelocitiesBeforeTheyAreSeen) {
    World world;
    const BodyId top = world.add(support::hook());
    const BodyId bob = world.add(support::body(Shape::sphere(0.1), {1, 0, 0}));
    support::rod(world, top, bob);
    double worst = 0.0;
    world.setForceField([&](const World& w, std::span<Load>) {
        const Vec3 along = w.pose(bob).position.normalized();
        worst = larger(worst, std::abs(along.dot(w.velocity(bob))));
    });
    support::run(world, 120);
    EXPECT_LT(worst, 1e-12);
}

}  // namespace
}  // namespace engine
