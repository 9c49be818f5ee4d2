// Motion blur: which moments a frame is the mean of.
#include "demos/film/shutter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demos {
namespace {

/// One ball at x = `place`, turned by `angle` about z.
render::Frame at(float place, float angle = 0.0f) {
    render::Frame frame;
    render::Solid ball;
    ball.position = {place, 0, 0};
    ball.rotation = Eigen::AngleAxisf(angle, render::Vec3::UnitZ());
    frame.solids.push_back(ball);
    frame.rods.push_back({{place, 0, 0}, {place, 1, 0}, 0.03f, {}});
    frame.camera.from.x() = place;
    return frame;
}

TEST(Shutter, ClosesAtTheFramesOwnTime) {
    const Shutter shutter({0.5, 4}, 4);  // open for two of four steps
    const auto moments = shutter.moments({at(0), at(4), at(8)});
    ASSERT_EQ(moments.size(), 4u);
    for (int i = 0; i < 4; ++i) {
        const float x = 2.0f * static_cast<float>(i + 1);
        EXPECT_FLOAT_EQ(moments[i].solids[0].position.x(), x) << i;
        EXPECT_FLOAT_EQ(moments[i].rods[0].to.x(), x) << i;
        EXPECT_FLOAT_EQ(moments[i].camera.from.x(), x) << i;
    }
}

TEST(Shutter, SeesAsManyStepsAsItIsOpen) {
    const Shutter half({0.5, 8}, 4), all({1.0, 8}, 4), part({0.3, 8}, 4), none({0.5, 1}, 4);
    for (int before = 0; before <= 4; ++before) {
        EXPECT_EQ(half.sees(before), before <= 2) << before;
        EXPECT_TRUE(all.sees(before)) << before;
        EXPECT_EQ(part.sees(before), before <= 2) << before;  // 1.2 steps: the second one as well
        EXPECT_EQ(none.sees(before), before == 0) << before;
    }
}

TEST(Shutter, StandsStillBeforeTheFirstStep) {
    const auto moments = Shutter({1.0, 8}, 2).moments({at(3)});
    ASSERT_EQ(moments.size(), 8u);
    for (const render::Frame& moment : moments)
        EXPECT_EQ(moment.solids[0].position.x(), 3.0f);
}

TEST(Shutter, ClosedAtOnceItSeesOneMomentManyTimes) {
    for (const render::Frame& moment : Shutter({0.0, 3}, 2).moments({at(1)}))
        EXPECT_EQ(moment.solids[0].position.x(), 1.0f);
}

TEST(Shutter, BodiesTurnEvenlyBetweenSteps) {
    const render::Frame middle = between(at(0, 0.0f), at(1, 1.0f), 0.5f);
    const Eigen::AngleAxisf turn(middle.solids[0].rotation);
    EXPECT_NEAR(turn.angle() * turn.axis().z(), 0.5f, 1e-6f);
}

TEST(Shutter, AnotherNumberOfBodiesIsNotMixed) {
    render::Frame two = at(5);
    two.solids.push_back(two.solids[0]);
    EXPECT_EQ(between(at(0), two, 0.5f).solids.size(), 2u);
    EXPECT_EQ(between(at(0), two, 0.5f).solids[0].position.x(), 5.0f);
}

}  // namespace
}  // namespace demos
