// The solver as a black box: bodies and hand-written contacts in, impulses out.
#include <gtest/gtest.h>

#include "engine/solver/impulses.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

/// mission 22: unit cube, 1 kg, falling with 1 m/s on four floor contacts.
struct CubeOnFloor {
    Constraints constraints;
    std::vector<Velocity> v{2};
    JointTrees trees;

    CubeOnFloor() {
        const InverseMass still, mass{1.0, 6.0 * Mat3::Identity()};
        Contact contact;
        contact.a = 0, contact.b = 1, contact.count = 4;
        const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        ContactGeometry points[4];
        for (int i = 0; i < 4; ++i) {
            points[i].armB = 0.5 * Vec3(corner[i][0], -1.0, corner[i][1]);
            points[i].armA = points[i].armB;
            points[i].separation = 0.0;
        }
        constraints.contacts.push_back(makeContactConstraint(contact, points, still, mass));
        constraints.order = {0};
        v[1].linear = {0.0, -1.0, 0.0};
    }
    void sweeps(int count, const Settings& settings) {
        for (int i = 0; i < count; ++i) sweep(constraints, trees, v, settings);
    }
    double lambda(int i) const { return constraints.contacts[0].rows[i].lambda; }
    double sum() const { return lambda(0) + lambda(1) + lambda(2) + lambda(3); }
};

/// To the digits printed in the mission.
constexpr double kNear = 5e-7;

TEST(SequentialImpulses, ClampTheTotal) {
    CubeOnFloor cube;
    const Settings seed = Settings::seed();
    cube.sweeps(1, seed);
    EXPECT_NEAR(cube.v[1].linear.y(), -0.035156, kNear);
    EXPECT_NEAR(cube.sum(), 0.964844, kNear);
    cube.sweeps(200, seed);
    EXPECT_NEAR(cube.v[1].linear.norm(), 0.0, 1e-6);
    EXPECT_NEAR(cube.v[1].angular.norm(), 0.0, 1e-6);
    EXPECT_NEAR(cube.sum(), 1.0, 1e-6);
    const double expected[4] = {.3125, .1875, .3125, .1875};
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(cube.lambda(i), expected[i], 1e-5);
}

TEST(SequentialImpulses, ClampingTheCorrectionIsStuck) {
    CubeOnFloor cube;
    Settings wrong = Settings::seed();
    wrong.accumulate = false;
    cube.sweeps(200, wrong);
    EXPECT_NEAR(cube.v[1].linear.y(), 0.032959, kNear);
    EXPECT_NEAR(cube.v[1].angular.norm(), 0.065190, kNear);
    const auto before = cube.v[1].linear.y();
    cube.sweeps(100, wrong);
    EXPECT_EQ(cube.v[1].linear.y(), before);
}

TEST(SequentialImpulses, TheBlockIsThereInAFewSweeps) {
    CubeOnFloor cube;
    cube.sweeps(4, Settings::steady());
    EXPECT_NEAR(cube.v[1].linear.norm(), 0.0, 1e-5);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(cube.lambda(i), 0.25, 1e-3);
}

// mission 21: stop on a count and/or a tolerance
TEST(Sweeps, StopWhenTheResidualIsSmall) {
    CubeOnFloor cube;
    std::vector<SweepReport> report;
    Settings settings = Settings::seed();
    settings.sweeps = 100, settings.minSweeps = 1, settings.tolerance = 1e-4;
    solveImpulses(cube.constraints, cube.trees, cube.v, settings, support::kStep, report);
    EXPECT_LT(report.size(), 40u);
    EXPECT_LT(report.back().residual, 1e-4);
    EXPECT_GE(report[report.size() - 2].residual, 1e-4);
    EXPECT_GT(report.front().delta, report.back().delta);

    CubeOnFloor counted;
    report.clear();
    settings.sweeps = 7, settings.tolerance = 0.0;
    solveImpulses(counted.constraints, counted.trees, counted.v, settings, support::kStep, report);
    EXPECT_EQ(report.size(), 7u);
}

TEST(Sweeps, ASpeculativeContactLetsTheGapCloseAndNoMore) {
    CubeOnFloor cube;
    for (auto& row : cube.constraints.contacts[0].rows) row.separation = 0.001;
    std::vector<SweepReport> report;
    solveImpulses(cube.constraints, cube.trees, cube.v, Settings::steady(), support::kStep, report);
    EXPECT_NEAR(cube.v[1].linear.y() * support::kStep, -0.001, 2e-5);
}

}  // namespace
}  // namespace engine
