// mission 20: bodies and hand-written contacts in, impulses and reaction forces out.
#include <gtest/gtest.h>

#include "engine/solver/impulses.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

constexpr int kBoxes = 5;

/// A stack of five unit boxes of 2 kg: four hand-written contact points per face.
struct Pile {
    Constraints constraints;
    std::vector<Velocity> v{kBoxes + 1};
    JointTrees trees;

    Pile() {
        const InverseMass still, box{0.5, 3.0 * Mat3::Identity()};  // I = m / 6
        const double corners[4][2] = {{-.5, -.5}, {.5, -.5}, {.5, .5}, {-.5, .5}};
        for (int i = 0; i < kBoxes; ++i) {
            Contact contact;
            contact.a = i, contact.b = i + 1, contact.count = 4;
            ContactGeometry points[4];
            for (int k = 0; k < 4; ++k)
                points[k] = {{corners[k][0], 0.5, corners[k][1]},
                             {corners[k][0], -0.5, corners[k][1]}, 0.0};
            constraints.contacts.push_back(
                makeContactConstraint(contact, points, i == 0 ? still : box, box));
            constraints.order.push_back(i);
        }
    }
    void step() {
        for (int i = 1; i <= kBoxes; ++i)
            v[i].linear.y() -= support::kGravity * support::kStep;
        std::vector<SweepReport> report;
        solveImpulses(constraints, trees, v, Settings::seed(), support::kStep, report);
    }
    /// N: sum of lambda / dt over the points of a contact.
    double force(int contact) const {
        double sum = 0.0;
        for (const auto& row : constraints.contacts[contact].rows) sum += row.lambda;
        return sum / support::kStep;
    }
};

// Reaction force = lambda / dt: 5 x 2 kg x 9.81 m/s^2 on the floor, one box less at every level.
TEST(BlackBox, FiveBoxesPressTheFloorWithTheirWeight) {
    Pile pile;
    for (int i = 0; i < 1000; ++i) pile.step();
    EXPECT_NEAR(pile.force(0), 98.1, 1e-6);
    for (int i = 0; i < kBoxes; ++i) {
        EXPECT_NEAR(pile.force(i), (kBoxes - i) * 19.62, 1e-6) << i;
        EXPECT_NEAR(pile.v[i + 1].linear.norm(), 0.0, 1e-9) << i;
    }
}

}  // namespace
}  // namespace engine
