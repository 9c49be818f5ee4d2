// What is kept of a run: which frames, which colours.
#include "demos/export/trajectory.h"

#include <gtest/gtest.h>

#include "demos/export/pose_table.h"
#include "tests/demos/reading.h"

namespace demos::test {
namespace {

Trajectory played(const std::string& text, int steps, int stepsPerFrame, Overlays overlays = {}) {
    Player player(read(text), overlays);
    player.watchTouches();
    TrajectoryRecorder recorder(stepsPerFrame, overlays);
    recorder.look(player, 0);
    for (int step = 1; step <= steps; ++step) {
        player.step();
        recorder.look(player, step);
    }
    return recorder.finished();
}

TEST(Trajectory, HasTheBeginningAndEveryNthStep) {
    const Trajectory run = played(kFloor + kBall, 10, 3);
    ASSERT_EQ(run.frames.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(run.frames[i].time, static_cast<double>(3 * i) / 60.0);
    EXPECT_EQ(run.frames[0].bodies[1].pose.position, Vec3(0, 2, 0));
    EXPECT_LT(run.frames[3].bodies[1].velocity.y(), -0.4);
    EXPECT_TRUE(run.frames[0].contacts.empty());
}

// The ball is on the floor after 0.55 s, and frames are far apart: the step between them counts.
TEST(Trajectory, HearsOfEventsBetweenItsFrames) {
    const Trajectory run = played(kFloor + kBall, 60, 60);
    ASSERT_EQ(run.frames.size(), 2u);
    ASSERT_GE(run.events.touches.size(), 1u);
    EXPECT_NEAR(run.events.touches[0].time, 0.553, 0.02);
}

TEST(Trajectory, AColorThatChangesWithTheRunIsLeftOut) {
    Overlays overlays;
    const Trajectory own = played(kFloor + kBall, 1, 1);
    overlays.colorBy = "speed";
    const Trajectory speed = played(kFloor + kBall, 1, 1, overlays);
    overlays.colorBy = "id";
    const Trajectory id = played(kFloor + kBall +
                                     "[[body]]\nname = 'red'\ncolour = '#ff0000'\n"
                                     "shape = { sphere = 0.1 }\nat = [9, 9, 9]\n",
                                 1, 1, overlays);
    EXPECT_EQ(speed.colors[1].b, own.colors[1].b);
    EXPECT_NE(id.colors[2].b, 0.0f);  // the palette's, not its own
}

TEST(PoseTable, HasARowAFrameAndBody) {
    const SceneDescription scene = read(kFloor + kBall);
    const Stage stage(scene);
    const Table table = poseTable("a.csv", stage, played(kFloor + kBall, 10, 5));
    EXPECT_EQ(table.rows(), 6);
    EXPECT_TRUE(table.text().starts_with(std::string(kPoseColumns) + "\n0,floor,0,0,0,1,0,0,0"));
}

}  // namespace
}  // namespace demos::test
