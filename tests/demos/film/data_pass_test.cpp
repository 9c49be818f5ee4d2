#include "demos/film/data_pass.h"

#include <gtest/gtest.h>

#include "demos/film/data_json.h"
#include "demos/snapshot/player.h"
#include "tests/demos/reading.h"

namespace demos {
namespace {

using test::sceneFrom;

/// A ball that bounces on a floor; the first touch is after 0.45 s of falling.
std::string bouncingFrom(double height) {
    return "format = 1\n[[material]]\nname = \"gum\"\nrestitution = 0.8\n"
           "[[body]]\nname = \"floor\"\nshape = { plane = [0, 1, 0] }\nfixed = true\n"
           "material = \"gum\"\n[[body]]\nname = \"ball\"\nshape = { sphere = 0.5 }\n"
           "material = \"gum\"\nat = [0, " +
           std::to_string(height) + ", 0]\n";
}

TEST(Passes, AreNamedOnceAndInOneOrder) {
    const std::vector<Pass> passes = passesCalled({"flow", "depth", "flow"});
    EXPECT_EQ(passes, (std::vector<Pass>{Pass::depth, Pass::flow}));
    EXPECT_EQ(passNamesOf(passes), (std::vector<std::string>{"depth", "flow"}));
    EXPECT_EQ(passesCalled(passNames()).size(), passTexts().size());
}

TEST(ContactLog, TellsWhenAPairBeginsToTouchAndWhenItParts) {
    Player player(sceneFrom(bouncingFrom(1.5)), {});
    ContactLog log;
    std::vector<ContactEvent> all;
    for (int step = 1; step <= 60; ++step) {
        player.step();
        log.look(player.stage());
        if (step % 2 != 0) continue;
        all.insert(all.end(), log.events().begin(), log.events().end());
        log.clear();
    }
    ASSERT_GE(all.size(), 2u);
    EXPECT_EQ(all.front().kind, ContactEvent::Kind::begin);
    EXPECT_NEAR(static_cast<double>(all.front().step), 27.0, 1.5);  // sqrt(2 h / g) = 0.4515 s
    EXPECT_GT(all.front().contact.impulse, 0.0);
    double pushed = 0.0;
    std::size_t i = 0;
    for (; all.at(i).kind != ContactEvent::Kind::end; ++i) pushed += all[i].contact.impulse;
    EXPECT_EQ(all[i].contact.a.index + all[i].contact.b.index, 1);
    // m v (1 + e), v = sqrt(2 g h), reverses the ball; the rest is its weight over a step or two
    const double mass = player.stage().world.mass(player.stage().bodies[1]);
    EXPECT_NEAR(pushed, mass * 4.4294 * 1.8, 0.1 * mass);
}

TEST(ContactLog, HoldsTheStepsOfOneFrameOnly) {
    Player player(sceneFrom(bouncingFrom(0.5)), {});
    ContactLog log;
    for (int step = 1; step <= 8; ++step) {
        if (step == 5) log.clear();
        player.step();
        log.look(player.stage());
    }
    ASSERT_EQ(log.events().size(), 4u);
    EXPECT_EQ(log.events().front().step, 5);
    EXPECT_EQ(log.events().front().kind, ContactEvent::Kind::persist);
}

TEST(DataNumbers, JointsComeAfterTheBodies) {
    const Stage stage(sceneFrom("format = 1\n[[body]]\nname = \"bob\"\nshape = { sphere = 0.1 }\n"
                                "at = [1, 2, 0]\n[[body]]\nname = \"floor\"\nfixed = true\n"
                                "shape = { plane = [0, 1, 0] }\n[[joint]]\ntype = \"ball\"\n"
                                "a = \"world\"\nb = \"bob\"\nanchor = [0, 2, 0]\n"));
    const render::Frame frame = snapshot(stage, {}, 0.0);
    EXPECT_EQ(frame.solids.at(0).id, 0);
    EXPECT_EQ(frame.grounds.at(0).id, 1);
    EXPECT_EQ(frame.rods.at(0).id, 2);
}

TEST(DepthUnit, ReachesTwiceAsFarAsTheScene) {
    EXPECT_DOUBLE_EQ(depthUnitOf(sceneFrom(bouncingFrom(1.5))), 1e-3);  // 17 m away
    EXPECT_DOUBLE_EQ(depthUnitOf(sceneFrom(bouncingFrom(200.0))), 1e-2);  // 197 m
}

}  // namespace
}  // namespace demos
