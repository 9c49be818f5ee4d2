// mission 29: a chain swept row by row converges slowly to its tensions, and every sweep reports its error.
#include <gtest/gtest.h>

#include "engine/solver/impulses.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

constexpr double kWeight = support::kGravity * support::kStep;  // N s: 1 kg in one step

/// Balls of 1 kg hanging one below the other, a row along y for each link, the top one first. The exact
/// impulse of a link is the weight below it.
struct HangingChain {
    Constraints constraints;
    std::vector<Velocity> v;
    JointTrees trees;

    explicit HangingChain(int count) : v(count + 1) {
        const InverseMass still, ball{1.0, 10.0 * Mat3::Identity()};
        for (int i = 0; i < count; ++i) {
            JointConstraint link;
            link.a = i, link.b = i + 1, link.count = 1;
            const Vec3 none = Vec3::Zero();
            link.rows[0] =
                makeRow(alongDirection({0, 1, 0}, none, none), i == 0 ? still : ball, ball);
            constraints.joints.push_back(link);
            v[i + 1].linear.y() = -kWeight;
        }
    }
    SweepReport sweepOnce() { return sweep(constraints, trees, v, Settings::seed()); }
    /// The smallest impulse of any link, as a share of its exact impulse.
    double share() const {
        const int count = static_cast<int>(constraints.joints.size());
        double least = 1.0;
        for (int i = 0; i < count; ++i)
            least = smaller(least, constraints.joints[i].lambda[0] / ((count - i) * kWeight));
        return least;
    }
};

int chainSweepsTo95Percent(int count) {
    HangingChain chain(count);
    int sweeps = 0;
    while (chain.share() < 0.95) chain.sweepOnce(), ++sweeps;
    return sweeps;
}

// 5 for two, 31 for five: it grows with the square of the length
TEST(ChainConvergence, TakesMoreSweepsTheLongerItIs) {
    EXPECT_EQ(chainSweepsTo95Percent(1), 1);
    EXPECT_EQ(chainSweepsTo95Percent(2), 5);
    EXPECT_EQ(chainSweepsTo95Percent(5), 31);
}

// Two links, by hand: every sweep halves the error.
TEST(ChainConvergence, TheReportIsTheLargestCorrectionAndTheSumOfImpulses) {
    HangingChain chain(2);
    const SweepReport first = chain.sweepOnce(), second = chain.sweepOnce();
    EXPECT_NEAR(first.residual, kWeight, 1e-15);      // both rows were off by one fall
    EXPECT_NEAR(first.delta, 1.5 * kWeight, 1e-15);   // 1 / K is 1 kg above and 1/2 kg below
    EXPECT_NEAR(second.residual, 0.5 * kWeight, 1e-15);
    EXPECT_NEAR(second.delta, 0.75 * kWeight, 1e-15);
}

TEST(ChainConvergence, TheResidualFallsFromSweepToSweep) {
    HangingChain chain(5);
    double before = 1e9;
    for (int i = 0; i < 200; ++i) {
        const double residual = chain.sweepOnce().residual;
        EXPECT_LE(residual, before) << i;
        before = residual;
    }
    EXPECT_LT(before, 1e-8);
    EXPECT_NEAR(chain.share(), 1.0, 1e-6);
}

// max |J v + b| over all rows once a sweep is done is no more than the correction it reported.
TEST(ChainConvergence, WhatIsReportedBoundsWhatIsLeft) {
    HangingChain chain(5);
    for (int i = 0; i < 50; ++i) {
        const double residual = chain.sweepOnce().residual;
        double left = 0.0;
        for (const JointConstraint& link : chain.constraints.joints)
            left = larger(left, std::abs(velocityAlong(link.rows[0].j, chain.v[link.a],
                                                       chain.v[link.b])));
        EXPECT_LE(left, residual) << i;
    }
}

}  // namespace
}  // namespace engine
