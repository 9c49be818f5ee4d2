// mission 24: ten equal spheres stacked, bottom first, ten sweeps a step, the velocity problem alone.
#include <gtest/gtest.h>

#include "engine/solver/impulses.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

constexpr int kSpheres = 10;

/// One point per pair, on the common axis: nothing turns, every ball weighs 1 kg.
struct Tower {
    Constraints<double> constraints;
    std::vector<Velocity<double>> v{kSpheres + 1};
    JointTrees trees;
    Settings settings = Settings::seed();

    Tower() {
        const InverseMass<double> still, ball{1.0, 10.0 * Mat3::Identity()};
        for (int i = 0; i < kSpheres; ++i) {
            Contact contact;
            contact.a = i, contact.b = i + 1, contact.count = 1;
            const ContactGeometry<double> point{{0, 0.5, 0}, {0, -0.5, 0}, 0.0};
            constraints.contacts.push_back(
                makeContactConstraint(contact, &point, i == 0 ? still : ball, ball));
            constraints.order.push_back(i);
        }
    }
    /// Gravity, ten sweeps; the bottom contact's impulse against what ten balls weigh in a step.
    double bottomShare(bool caching) {
        settings.warmStart = caching;
        for (int i = 1; i <= kSpheres; ++i) {
            v[i] = {};
            v[i].linear.y() = -support::kGravity * support::kStep;
        }
        std::vector<SweepReport> report;
        solveImpulses<double>(constraints, trees, v, settings, support::kStep, report);
        return constraints.contacts[0].rows[0].lambda /
               (kSpheres * support::kGravity * support::kStep);
    }
};

TEST(ContactCaching, WithoutItTheBottomImpulseStaysShort) {
    Tower tower;
    for (int i = 0; i < 50; ++i) EXPECT_NEAR(1.0 - tower.bottomShare(false), 0.648, 5e-4);
}

TEST(ContactCaching, WithItTheBottomImpulseIsThereAfterThirteenSteps) {
    Tower tower;
    double share = 0.0;
    for (int i = 0; i < 13; ++i) share = tower.bottomShare(true);
    EXPECT_NEAR(share, 1.0, 0.05);
    for (int i = 0; i < 200; ++i) share = tower.bottomShare(true);
    EXPECT_NEAR(share, 1.0, 1e-9);
}

}  // namespace
}  // namespace engine
