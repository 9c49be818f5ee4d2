#include "engine/solver/joint_trees.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "tests/support/worlds.h"

namespace engine {
namespace {

/// Ball joints between random bodies; body 0 is fixed.
struct Jointed {
    std::vector<InverseMass<double>> masses;
    std::vector<Velocity<double>> v;
    std::vector<JointConstraint<double>> joints;
    support::Random random;

    Jointed(int bodies, std::uint64_t seed) : masses(bodies), v(bodies), random(seed) {
        for (int i = 1; i < bodies; ++i) {
            masses[i].linear = random.number(0.01, 3.0);
            const Mat3 r = random.rotation().toRotationMatrix();
            const Vec3 moments = random.vector(1).cwiseAbs() + Vec3::Constant(0.3);
            masses[i].angular = r * moments.asDiagonal() * r.transpose();
            v[i] = {random.vector(3), random.vector(3)};
        }
    }
    void connect(int a, int b) {
        JointConstraint<double> joint;
        joint.a = a, joint.b = b, joint.count = 3;
        const Vec3 ra = random.vector(1), rb = random.vector(1);
        for (int i = 0; i < 3; ++i)
            joint.rows[i] =
                makeRow(alongDirection<double>(Vec3::Unit(i), ra, rb), masses[a], masses[b]);
        joints.push_back(joint);
    }
    double worstVelocity() const {
        double worst = 0.0;
        for (const auto& joint : joints)
            for (int i = 0; i < joint.count; ++i)
                if (joint.inTree)
                    worst = larger(worst, std::abs(velocityAlong(joint.rows[i].j, v[joint.a],
                                                                 v[joint.b])));
        return worst;
    }
    void solve(JointTrees& trees) {
        trees.build(joints, masses);
        trees.factor(joints);
        Correction<double> correction;
        trees.solveVelocities(joints, v, correction);
    }
};

TEST(JointTrees, OneSolveSatisfiesAllJoints) {
    Jointed j(60, 1);
    for (int i = 1; i < 60; ++i) j.connect(static_cast<int>(j.random.number(0, i)), i);
    const double before = j.worstVelocity();
    (void)before;
    JointTrees trees;
    j.solve(trees);
    EXPECT_EQ(trees.order().size(), 59u);
    EXPECT_LT(j.worstVelocity(), 1e-10);
}

TEST(JointTrees, AgreesWithTheDenseSystem) {
    Jointed j(6, 2);
    for (int i = 1; i < 6; ++i) j.connect(i / 2, i);
    const int rows = 15;
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(rows, 36), inverse = jacobian;
    Eigen::VectorXd rhs(rows);
    for (int k = 0; k < 5; ++k)
        for (int i = 0; i < 3; ++i) {
            const Row<double>& row = j.joints[k].rows[i];
            const int a = 6 * j.joints[k].a, b = 6 * j.joints[k].b, r = 3 * k + i;
            jacobian.row(r).segment<3>(a) -= row.j.linear.transpose();
            jacobian.row(r).segment<3>(a + 3) += row.j.angularA.transpose();
            jacobian.row(r).segment<3>(b) += row.j.linear.transpose();
            jacobian.row(r).segment<3>(b + 3) += row.j.angularB.transpose();
            rhs[r] = -velocityAlong(row.j, j.v[j.joints[k].a], j.v[j.joints[k].b]);
        }
    Eigen::MatrixXd massInverse = Eigen::MatrixXd::Zero(36, 36);
    for (int i = 0; i < 6; ++i) {
        massInverse.block<3, 3>(6 * i, 6 * i) = j.masses[i].linear * Mat3::Identity();
        massInverse.block<3, 3>(6 * i + 3, 6 * i + 3) = j.masses[i].angular;
    }
    const Eigen::VectorXd expected =
        (jacobian * massInverse * jacobian.transpose()).eval().ldlt().solve(rhs);
    JointTrees trees;
    j.solve(trees);
    for (int k = 0; k < 5; ++k)
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(j.joints[k].lambda[i], expected[3 * k + i], 1e-9);
}

TEST(JointTrees, LeaveALoopsLastJointToTheSweep) {
    Jointed j(4, 3);
    j.connect(1, 2);
    j.connect(2, 3);
    j.connect(3, 1);
    JointTrees trees;
    j.solve(trees);
    EXPECT_TRUE(j.joints[0].inTree && j.joints[1].inTree);
    EXPECT_FALSE(j.joints[2].inTree);
}

// A chain costs blocks linear in its length: no joint is coupled with more than two others.
TEST(JointTrees, AChainHoldsFixedEndsToo) {
    Jointed j(40, 4);
    for (int i = 1; i < 40; ++i) j.connect(i - 1, i);
    j.connect(39, 0);
    JointTrees trees;
    j.solve(trees);
    EXPECT_EQ(trees.order().size(), 40u);
    EXPECT_LT(j.worstVelocity(), 1e-10);
}

// Twice the same joint: the second follows from the first. And two that contradict each other.
TEST(JointTrees, RedundantRowsGetNoImpulseAndContradictionsNoInfinity) {
    Jointed j(2, 5);
    j.connect(0, 1);
    j.joints.push_back(j.joints[0]);
    for (int i = 0; i < 3; ++i) j.joints[0].bias[i] = 1.0, j.joints[1].bias[i] = -1.0;
    JointTrees trees;
    j.solve(trees);
    for (const auto& joint : j.joints)
        for (int i = 0; i < 3; ++i) EXPECT_LT(std::abs(joint.lambda[i]), 100.0);
    EXPECT_TRUE(j.v[1].linear.allFinite());
    EXPECT_LT(j.v[1].linear.norm(), 100.0);
}

}  // namespace
}  // namespace engine
