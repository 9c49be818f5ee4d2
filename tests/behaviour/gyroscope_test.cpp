// mission 6: a box spun about its middle axis flips repeatedly (Dzhanibekov).
#include <gtest/gtest.h>

#include "engine/shapes/mass.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

struct Spin {
    World world;
    BodyId id;

    Spin(Gyroscope gyroscope, int substeps) : world(settings(gyroscope, substeps)) {
        world.setGravity(Vec3::Zero());
        BodyDef box = support::body(Shape::box({1, 2, 4}), Vec3::Zero(), 1.0);
        box.spin = {0.1, 5.0, 0.1};
        id = world.add(box);
    }
    static Settings settings(Gyroscope gyroscope, int substeps) {
        Settings s = Settings::steady();
        s.gyroscope = gyroscope;
        s.substeps = s.maxSubsteps = substeps;
        return s;
    }
    Vec3 momentum() const {
        return inWorldAxes(world.inertia(id), world.pose(id).rotation) * world.spin(id);
    }
    /// The body's y axis: up at the start.
    double up() const { return (world.pose(id).rotation * Vec3(0, 1, 0)).y(); }
};

TEST(Gyroscope, ImplicitEulerFlipsAndNeverGainsEnergy) {
    Spin spin(Gyroscope::implicitEuler, 1);
    const double energy = spin.world.energy().total();
    const Vec3 momentum = spin.momentum();
    bool flipped = false;
    double worstGain = 0.0, worstTurn = 0.0;
    for (int i = 0; i < 2400; ++i) {
        spin.world.step(1.0 / 240);
        flipped = flipped || spin.up() < -0.9;
        worstGain = larger(worstGain, spin.world.energy().total() / energy - 1.0);
        worstTurn = larger(worstTurn, (spin.momentum() - momentum).norm() / momentum.norm());
    }
    EXPECT_TRUE(flipped);
    EXPECT_LT(worstGain, 1e-3);
    EXPECT_LT(worstTurn, 0.03);
}

TEST(Gyroscope, MomentumFlipsAndKeepsEnergyAndMomentum) {
    Spin spin(Gyroscope::momentum, 4);
    // {0.1, 5, 0.1} is on the separatrix, L^2 = 2 E I: one flip only.
    spin.world.setVelocity(spin.id, Vec3::Zero(), {0.1, 5.0, 0.05});
    const double energy = spin.world.energy().total();
    const Vec3 momentum = spin.momentum();
    int flips = 0;
    bool down = false;
    double worst = 0.0;
    for (int i = 0; i < 600; ++i) {
        spin.world.step(support::kStep);
        if (down ? spin.up() > 0.9 : spin.up() < -0.9) down = !down, ++flips;
        worst = larger(worst, std::abs(spin.world.energy().total() / energy - 1.0));
    }
    EXPECT_GE(flips, 2);
    EXPECT_LT(worst, 1e-3);
    EXPECT_LT((spin.momentum() - momentum).norm(), 1e-10 * momentum.norm());
}

TEST(Gyroscope, WithoutTheTermItNeverFlips) {
    Spin spin(Gyroscope::none, 1);
    double least = 1.0;
    for (int i = 0; i < 2400; ++i) {
        spin.world.step(1.0 / 240);
        least = smaller(least, spin.up());
    }
    EXPECT_GT(least, 0.9);
}

}  // namespace
}  // namespace engine
