// Joints as bars that keep their numbers: their ends, and bars that are gone.
#include "demos/export/bars.h"

#include <gtest/gtest.h>

#include "tests/demos/recorded.h"

namespace demos::test {
namespace {

struct Barred : Recorded {
    std::vector<BarMotion> bars;

    explicit Barred(const std::string& text, int steps = 60)
        : Recorded(text, steps), bars(barsOf(run)) {}
};

Vec3 endOf(const BarMotion& bar, std::size_t frame, double side) {
    const double half = static_cast<double>(bar.sizes[frame].y());
    return bar.poses[frame].toWorld(side * half * Vec3::UnitY());
}

TEST(Bars, ARodGoesFromItsHookToItsBobInEveryFrame) {
    const Barred one(kPendulum);
    ASSERT_EQ(one.bars.size(), 1u);
    EXPECT_EQ(one.bars[0].name, "hook bar 1");
    ASSERT_EQ(one.bars[0].poses.size(), 61u);
    for (std::size_t frame = 0; frame <= 60; ++frame) {
        const Vec3 bob = one.run.frames[frame].bodies[0].pose.position;
        EXPECT_LT((endOf(one.bars[0], frame, -1.0) - Vec3(0, 2, 0)).norm(), 1e-5);
        EXPECT_LT((endOf(one.bars[0], frame, 1.0) - bob).norm(), 1e-5);
    }
}

// It swings by half a turn in these frames and does not turn about its own axis.
TEST(Bars, ABarDoesNotTwist) {
    const Barred one(kPendulum);
    for (const engine::Pose& pose : one.bars[0].poses)
        EXPECT_NEAR(std::abs((pose.rotation * Vec3::UnitZ()).z()), 1.0, 1e-6);
}

TEST(Bars, ASpringIsOneBar) {
    const Barred one(
        "[[body]]\nname = 'bob'\nshape = { sphere = 0.1 }\nat = [0, 2, 0]\n[[force]]\n"
        "type = 'spring'\na = 'world'\nb = 'bob'\nanchor_a = [0, 4, 0]\nstiffness = 500\n");
    ASSERT_EQ(one.bars.size(), 1u);
    EXPECT_EQ(one.bars[0].name, "spring 0 bar 1");
    EXPECT_LT((endOf(one.bars[0], 0, 1.0) - Vec3(0, 2, 0)).norm(), 1e-5);
    EXPECT_LT((endOf(one.bars[0], 0, -1.0) - Vec3(0, 4, 0)).norm(), 1e-5);
}

// It breaks at once and leaves a bar of size 0.
TEST(Bars, ABrokenOneIsGoneFromThenOn) {
    const Barred one(kPendulum + "break_at = 0.001\n");
    ASSERT_EQ(one.bars.size(), 1u);
    EXPECT_GT(one.bars[0].sizes[0].y(), 0.4f);
    EXPECT_TRUE(one.bars[0].sizes[60].isZero());
    ASSERT_EQ(one.bars[0].poses.size(), 61u);
}

TEST(Bars, OfNoJointsAreNone) { EXPECT_TRUE(Barred(kFloor + kBall, 2).bars.empty()); }

}  // namespace
}  // namespace demos::test
