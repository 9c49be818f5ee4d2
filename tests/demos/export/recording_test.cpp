// What is kept of a run: which frames, which colours, which bars.
#include <gtest/gtest.h>

#include "demos/export/pose_table.h"
#include "demos/load/load_scene.h"
#include "tests/demos/recorded.h"

namespace demos::test {
namespace {

TEST(Recording, HasTheBeginningAndEveryNthStep) {
    const Recording run = Recorded(kFloor + kBall, 10, 3).run;
    ASSERT_EQ(run.frames.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(run.frames[i].time, static_cast<double>(3 * i) / 60.0);
    EXPECT_EQ(run.frames[0].bodies[1].pose.position, Vec3(0, 2, 0));
    EXPECT_LT(run.frames[3].bodies[1].velocity.y(), -0.4);
    EXPECT_TRUE(run.frames[0].contacts.empty());
}

TEST(Recording, IsWhatAPlayerShowsFrameByFrame) {
    const Recorded one(kFloor + kBall, 300, 2);
    ASSERT_EQ(one.run.frames.size(), 151u);
    Player player(read(kFloor + kBall), {});
    player.step(20 * 2);
    const engine::Pose& pose = player.stage().world.pose(player.stage().bodies[1]);
    EXPECT_EQ(one.run.frames[20].bodies[1].pose.position, pose.position);
    EXPECT_EQ(one.run.grounds.size(), 1u);
    EXPECT_EQ(one.run.frames[150].contacts.size(), 1u);
}

// The ball is on the floor after 0.55 s, between two frames; the steps between them count.
TEST(Recording, HearsOfEventsBetweenItsFrames) {
    const Recording run = Recorded(kFloor + kBall, 60, 60).run;
    ASSERT_EQ(run.frames.size(), 2u);
    ASSERT_GE(run.events.touches.size(), 1u);
    EXPECT_NEAR(run.events.touches[0].time, 0.553, 0.02);
}

TEST(Recording, AColorThatChangesWithTheRunIsLeftOut) {
    Overlays overlays;
    const Recording own = Recorded(kFloor + kBall, 1).run;
    overlays.colorBy = "speed";
    const Recording speed = Recorded(kFloor + kBall, 1, 1, overlays).run;
    overlays.colorBy = "id";
    const Recording id = Recorded(kFloor + kBall +
                                      "[[body]]\nname = 'red'\ncolour = '#ff0000'\n"
                                      "shape = { sphere = 0.1 }\nat = [9, 9, 9]\n",
                                  1, 1, overlays)
                             .run;
    EXPECT_EQ(speed.bodies[1].color.b, own.bodies[1].color.b);
    EXPECT_NE(id.bodies[2].color.b, 0.0f);  // the palette's, not its own
}

/// Recorded bars are fixed to bodies; the renderer computes its own for every picture.
TEST(Recording, BarsAreWhereTheRendererDrawsThem) {
    for (const char* name : {"chain", "ragdoll", "scissor-lift", "newtons-cradle"}) {
        const Recorded one(loadScene(name, {}), 2, 2);
        const std::vector<render::Rod> rods = one.player.frame(0.0).rods;
        ASSERT_EQ(one.run.bars.size(), rods.size()) << name;
        const auto place = [&](int body, const Vec3& local) {
            return body < 0 ? local : one.run.frames[1].bodies[body].pose.toWorld(local);
        };
        for (std::size_t i = 0; i < rods.size(); ++i) {
            const JointBar& bar = one.run.bars[i];
            EXPECT_LT((place(bar.a, bar.atA).cast<float>() - rods[i].from).norm(), 1e-4f) << name;
            EXPECT_LT((place(bar.b, bar.atB).cast<float>() - rods[i].to).norm(), 1e-4f) << name;
        }
    }
}

// Nothing stops the bob, which slides by 3 m: its rail is as long as its way.
TEST(Recording, ARailReachesAsFarAsTheRunGoes) {
    const Recorded one(
        "[world]\ngravity = [0, 0, 0]\n[[body]]\nname = 'bob'\nshape = { sphere = 0.1 }\n"
        "at = [0, 2, 0]\nvelocity = [3, 0, 0]\n[[joint]]\nname = 'rail'\ntype = 'slider'\n"
        "a = 'world'\nb = 'bob'\nanchor = [0, 2, 0]\naxis = [1, 0, 0]\n");
    ASSERT_EQ(one.run.bars.size(), 1u);
    EXPECT_NEAR(one.run.bars[0].atA.x(), -0.1, 1e-9);
    EXPECT_NEAR(one.run.bars[0].atB.x(), 3.1, 1e-6);
    EXPECT_NEAR(one.run.frames[0].bars[0].atB.x(), 0.1, 1e-9);
}

// A joint that breaks is in the pictures only until then.
TEST(Recording, ABrokenJointHasFramesUntilItBroke) {
    const Recorded one(kPendulum + "break_at = 0.001\n");
    ASSERT_EQ(one.run.bars.size(), 1u);
    const int frames = one.run.joints[0].frames;
    EXPECT_GT(frames, 0);
    EXPECT_LT(frames, 61);
    for (int i = 0; i < 61; ++i)
        EXPECT_EQ(one.run.frames[i].bars.size(), i < frames ? 1u : 0u) << i;
}

TEST(PoseTable, HasARowAFrameAndBody) {
    const Table table = poseTable("a.csv", Recorded(kFloor + kBall, 10, 5).run);
    EXPECT_EQ(table.rows(), 6);
    EXPECT_TRUE(table.text().starts_with(std::string(kPoseColumns) + "\n0,floor,0,0,0,1,0,0,0"));
}

}  // namespace
}  // namespace demos::test
