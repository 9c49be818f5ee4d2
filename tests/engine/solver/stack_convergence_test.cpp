// mission 30: a stack of spheres fed to the solver bottom first (Catto, GDC 2014).
#include <gtest/gtest.h>

#include "engine/solver/impulses.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

/// A stack of spheres, one contact each, the lowest first; they have fallen for one step.
struct SphereStack {
    Constraints constraints;
    std::vector<Velocity> v{1};
    std::vector<double> exact;  // N s: load on each contact

    explicit SphereStack(const std::vector<double>& masses) {
        InverseMass below;
        for (const double mass : masses) {
            const InverseMass ball{1.0 / mass, 10.0 / mass * Mat3::Identity()};
            const int i = static_cast<int>(exact.size());
            Contact contact;
            contact.a = i, contact.b = i + 1, contact.count = 1;
            const ContactGeometry point{{0, 0.5, 0}, {0, -0.5, 0}, 0.0};
            constraints.contacts.push_back(makeContactConstraint(contact, &point, below, ball));
            constraints.order.push_back(i);
            v.push_back({{0, -support::kGravity * support::kStep, 0}, Vec3::Zero()});
            exact.push_back(0.0);
            for (double& load : exact) load += mass * support::kGravity * support::kStep;
            below = ball;
        }
    }
    double share() const {
        double least = 1.0;
        for (std::size_t i = 0; i < exact.size(); ++i)
            least = smaller(least, constraints.contacts[i].rows[0].lambda / exact[i]);
        return least;
    }
};

int stackSweepsTo95Percent(const std::vector<double>& masses) {
    SphereStack stack(masses);
    JointTrees trees;
    int sweeps = 0;
    while (stack.share() < 0.95)
        sweep(stack.constraints, trees, stack.v, Settings::seed()), ++sweeps;
    return sweeps;
}

// 1, 5, 20 sweeps for 1, 2, 4 equal spheres
TEST(StackConvergence, TakesMoreSweepsTheHigherItIs) {
    EXPECT_EQ(stackSweepsTo95Percent({1}), 1);
    EXPECT_EQ(stackSweepsTo95Percent({1, 1}), 5);
    EXPECT_EQ(stackSweepsTo95Percent({1, 1, 1, 1}), 20);
}

// 3 ratio + 2
TEST(StackConvergence, TakesThreeSweepsMoreForEveryMassOfTheUpper) {
    const std::pair<double, int> expected[] = {{1, 5}, {2, 8}, {3, 11}, {5, 17}, {8, 26}, {10, 32}};
    for (const auto& [ratio, sweeps] : expected) {
        EXPECT_EQ(stackSweepsTo95Percent({1, ratio}), sweeps) << ratio;
        EXPECT_EQ(sweeps, 3 * static_cast<int>(ratio) + 2);
    }
}

// Light on heavy converges fast: the upper body adds only a small part of the load.
TEST(StackConvergence, TakesAFewSweepsForLightOnHeavy) {
    EXPECT_LE(stackSweepsTo95Percent({10, 1}), 3);
}

}  // namespace
}  // namespace engine
