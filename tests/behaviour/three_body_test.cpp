// mission 3: three bodies of unit mass that chase each other along a figure eight (Moore 1993;
// Chenciner and Montgomery 2000). The forces depend on positions and are evaluated in every
// sub-step.
#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace engine {
namespace {

struct FigureEight {
    static constexpr double kPeriod = 6.32591398;  // s
    World world;
    std::vector<Vec3> start;

    FigureEight() : world(oneSubstep()) {
        world.setGravity(Vec3::Zero());
        const Vec3 x1(0.97000436, -0.24308753, 0), v3(-0.93240737, -0.86473146, 0);
        start = {x1, -x1, Vec3::Zero()};
        const Vec3 v[3] = {-v3 / 2, -v3 / 2, v3};
        for (int i = 0; i < 3; ++i) {
            BodyDef star = support::body(Shape::sphere(0.01), start[i], 1.0);
            star.velocity = v[i];
            star.collide = false;
            world.add(star);
        }
        world.add(ForceDef{NBodyGravity{1.0, 0.0}, {{0}, {1}, {2}}});  // G = m = 1
    }
    static Settings oneSubstep() {
        Settings s = Settings::steady();
        s.substeps = s.maxSubsteps = 1;
        return s;
    }
    /// Largest distance of a body from its start after one period, in steps of about dt.
    double closure(double dt) {
        const int steps = static_cast<int>(kPeriod / dt + 0.5);
        support::run(world, steps, kPeriod / steps);
        double worst = 0.0;
        for (int i = 0; i < 3; ++i)
            worst = larger(worst, (world.pose({i}).position - start[i]).norm());
        return worst;
    }
};

// about 0.0085 at dt = 1/240
TEST(ThreeBodies, CloseTheFigureEight) {
    EXPECT_NEAR(FigureEight().closure(1.0 / 240), 0.0085, 5e-5);
}

// mission 2: halving dt halves the error
TEST(ThreeBodies, CloseTwiceAsWellInHalfTheStep) {
    const double whole = FigureEight().closure(1.0 / 240), half = FigureEight().closure(1.0 / 480);
    EXPECT_NEAR(whole / half, 2.0, 0.02);
}

// Only forces between the bodies: the centre of mass stays, and no energy is gained.
TEST(ThreeBodies, KeepTheirCentreOfMass) {
    FigureEight eight;
    support::run(eight.world, 6000);
    Vec3 momentum = Vec3::Zero(), centre = Vec3::Zero();
    for (int i = 0; i < 3; ++i)
        momentum += eight.world.velocity({i}), centre += eight.world.pose({i}).position;
    EXPECT_LT(momentum.norm(), 1e-12);
    EXPECT_LT(centre.norm(), 1e-10);
}

}  // namespace
}  // namespace engine
