// mission 24: ten equal spheres stacked, bottom first, ten sweeps per step, only the velocity problem.
#include <gtest/gtest.h>

#include "engine/solver/impulses.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

constexpr int kSpheres = 10;

/// One point per pair, on the common axis, without rotation; every ball has 1 kg.
struct Tower {
    Constraints constraints;
    std::vector<Velocity> v{kSpheres + 1};
    JointTrees trees;
    Settings settings = Settings::seed();

    Tower() {
        const InverseMass still, ball{1.0, 10.0 * Mat3::Identity()};
        for (int i = 0; i < kSpheres; ++i) {
            Contact contact;
            contact.a = i, contact.b = i + 1, contact.count = 1;
            const ContactGeometry point{{0, 0.5, 0}, {0, -0.5, 0}, 0.0};
            constraints.contacts.push_back(
                makeContactConstraint(contact, &point, i == 0 ? still : ball, ball));
            constraints.order.push_back(i);
        }
    }
    /// One step: gravity, ten sweeps.
    void step(bool caching) {
        settings.warmStart = caching;
        for (int i = 1; i <= kSpheres; ++i) {
            v[i] = {};
            v[i].linear.y() = -support::kGravity * support::kStep;
        }
        std::vector<SweepReport> report;
        solveImpulses(constraints, trees, v, settings, support::kStep, report);
    }
    /// A contact's impulse relative to the weight of the balls above it in a step.
    double share(int contact) const {
        return constraints.contacts[contact].rows[0].lambda /
               ((kSpheres - contact) * support::kGravity * support::kStep);
    }
    double leastShare() const {
        double least = 1.0;
        for (int i = 0; i < kSpheres; ++i) least = smaller(least, share(i));
        return least;
    }
};

TEST(ContactCaching, WithoutItTheBottomImpulseStaysShort) {
    Tower tower;
    for (int i = 0; i < 50; ++i) {
        tower.step(false);
        EXPECT_NEAR(1.0 - tower.share(0), 0.648, 5e-4);
    }
}

// within 5 % after 13 steps: the slowest of the ten contacts (the bottom one is there a step sooner)
TEST(ContactCaching, WithItEveryImpulseIsThereAfterThirteenSteps) {
    Tower tower;
    int steps = 0;
    while (tower.leastShare() < 0.95) tower.step(true), ++steps;
    EXPECT_EQ(steps, 13);
    EXPECT_NEAR(tower.share(0), 1.0, 0.05);
    for (int i = 0; i < 200; ++i) tower.step(true);
    for (int i = 0; i < kSpheres; ++i) EXPECT_NEAR(tower.share(i), 1.0, 1e-9) << i;
}

}  // namespace
}  // namespace engine
