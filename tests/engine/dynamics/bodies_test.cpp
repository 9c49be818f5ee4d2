#include "engine/dynamics/bodies.h"

#include <gtest/gtest.h>

#include "engine/dynamics/energy.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

/// A dynamic, a kinematic, a fixed and a dynamic body, not placed since the last step.
Bodies fourBodies() {
    Bodies bodies;
    const BodyKind kinds[] = {BodyKind::dynamic, BodyKind::kinematic, BodyKind::fixed,
                              BodyKind::dynamic};
    for (const BodyKind kind : kinds) {
        BodyDef def = support::body(Shape::sphere(0.5), {0, 1.0 + bodies.count(), 0}, 2.0);
        def.kind = kind;
        addBody(bodies, def, bodies.count());
    }
    std::ranges::fill(bodies.placed, char{0});
    bodies.activeShrinks = true;
    return bodies;
}

void sleep(Bodies& bodies, int i) {
    bodies.asleep[i] = i;
    bodies.activeShrinks = true;
}

TEST(ActiveBodies, AreAllNewOnesAndThenThoseThatMove) {
    Bodies bodies = fourBodies();
    EXPECT_EQ(bodies.active, (std::vector{0, 1, 2, 3}));
    leaveOutResting(bodies);
    EXPECT_EQ(bodies.active, (std::vector{0, 1, 3}));
}

TEST(ActiveBodies, LeaveWhenTheySleepAndComeBackInOrder) {
    Bodies bodies = fourBodies();
    sleep(bodies, 0);
    leaveOutResting(bodies);
    EXPECT_EQ(bodies.active, (std::vector{1, 3}));
    bodies.asleep[0] = -1;
    activate(bodies, 0), activate(bodies, 0);
    EXPECT_EQ(bodies.active, (std::vector{0, 1, 3}));
}

TEST(ActiveBodies, IncludeASleepingOneThatWasPlaced) {
    Bodies bodies = fourBodies();
    sleep(bodies, 0);
    bodies.placed[0] = 1;
    leaveOutResting(bodies);
    EXPECT_EQ(bodies.active, (std::vector{0, 1, 3}));
}

TEST(ActiveBodies, AndTheOthersHaveOnePotentialEnergy) {
    Bodies bodies = fourBodies();
    const Vec3 gravity(0, -10, 0);
    const double all = 2.0 * 10.0 * (1.0 + 4.0);  // m g (y_0 + y_3)
    EXPECT_NEAR(energyOf(bodies, gravity).potential, all, 1e-12 * all);
    sleep(bodies, 0), sleep(bodies, 3);
    leaveOutResting(bodies);
    EXPECT_NEAR(energyOf(bodies, gravity).potential, all, 1e-12 * all);
    sumResting(bodies);
    EXPECT_NEAR(energyOf(bodies, gravity).potential, all, 1e-12 * all);
    activate(bodies, 3);  // its part counts once
    EXPECT_NEAR(energyOf(bodies, gravity).potential, all, 1e-12 * all);
}

}  // namespace
}  // namespace engine
