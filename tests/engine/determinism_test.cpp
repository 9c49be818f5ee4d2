// mission 10: the same scene twice gives the same bits. The hashes themselves are golden: compared
// over compilers and optimisation levels by tests/golden (see tests/README.md).
#include <gtest/gtest.h>

#include "tests/support/golden_worlds.h"

namespace engine {
namespace {

class Golden : public testing::TestWithParam<int> {};

void expectGolden(const support::GoldenWorld& golden, const Settings& settings) {
    World world = golden.make();
    world.setSettings(settings);
    for (int i = 0; i < golden.steps; ++i) ASSERT_TRUE(world.step(support::kStep));
    EXPECT_EQ(world.hash(), golden.hash)
        << golden.name << ": a changed hash is explained in its commit; now 0x" << std::hex
        << world.hash();
}

TEST_P(Golden, TheTrajectoryIsTheSameBitForBit) {
    expectGolden(support::goldenWorlds()[GetParam()], Settings::steady());
}

// 1 thread is the test above; 4 are more than the work needs, and maybe more than the processors.
TEST_P(Golden, TheTrajectoryIsTheSameWithTwoAndFourThreads) {
    for (const int threads : {2, 4}) {
        Settings settings = Settings::steady();
        settings.threads = threads;
        expectGolden(support::goldenWorlds()[GetParam()], settings);
    }
}

TEST_P(Golden, TheTrajectoryIsTheSameWithTheInstructionsThatEveryProcessorHas) {
    Settings settings = Settings::steady();
    settings.instructions = Instructions::baseline;
    settings.threads = 2;
    expectGolden(support::goldenWorlds()[GetParam()], settings);
}

INSTANTIATE_TEST_SUITE_P(Worlds, Golden, testing::Range(0, 8), [](const auto& one) {
    return std::string(support::goldenWorlds()[one.param].name);
});

/// So many bodies that threads share also what is done body by body (wide_contacts.cpp: 512 for each), in tilted
/// piles, with balls so fast that they are looked at within a step.
World crowd(int threads) {
    Settings settings = Settings::steady();
    settings.threads = threads;
    World world(settings);
    world.add(support::floorPlane());
    for (int i = 0; i < 1200; ++i) {
        BodyDef box = support::body(Shape::box({1, 1, 1}), {1.6 * (i % 20), 0.5 + i / 400, 1.6 * (i / 20 % 20)});
        box.pose.rotation = turnAboutXyz({0.1, 0.3 * (i % 5), 0});
        world.add(box);
    }
    for (int i = 0; i < 200; ++i) {
        BodyDef ball = support::body(Shape::sphere(0.3), {-3.0, 0.5 + i / 20, 1.6 * (i % 20)});
        ball.velocity = {80, 0, 0};
        world.add(ball);
    }
    return world;
}

TEST(Determinism, TwoAndFourThreadsShareACrowd) {
    World one = crowd(1), two = crowd(2), four = crowd(4);
    for (int i = 0; i < 8; ++i) {
        for (World* world : {&one, &two, &four}) ASSERT_TRUE(world->step(support::kStep));
        ASSERT_EQ(one.hash(), two.hash()) << "step " << i;
        ASSERT_EQ(one.hash(), four.hash()) << "step " << i;
    }
}

TEST(Determinism, AWorldBuiltLaterOnAnotherHeapIsTheSame) {
    const support::GoldenWorld& golden = support::goldenWorlds()[0];
    World first = golden.make();
    std::vector<std::vector<char>> clutter;
    for (int i = 0; i < 100; ++i) clutter.emplace_back(100 * i + 1);
    World second = golden.make();
    for (int i = 0; i < 60; ++i) first.step(support::kStep), second.step(support::kStep);
    EXPECT_EQ(first.hash(), second.hash());
}

TEST(Determinism, TheHashSeesAChangeOfOneBit) {
    World a = support::stack(3), b = support::stack(3);
    EXPECT_EQ(a.hash(), b.hash());
    Pose pose = b.pose({2});
    pose.position.x() += 0x1.0p-60;
    b.setPose({2}, pose);
    EXPECT_NE(a.hash(), b.hash());
}

}  // namespace
}  // namespace engine
