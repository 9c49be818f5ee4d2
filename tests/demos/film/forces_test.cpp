// [[force]], groups, sensors and kinematic paths: from the text to the motion.
#include <gtest/gtest.h>

#include <cmath>

#include "demos/film/event_log.h"
#include "demos/play/stage.h"
#include "engine/base/trigonometry.h"
#include "tests/demos/reading.h"

namespace demos::test {
namespace {

const std::string kSpace = "[world]\ngravity = [0, 0, 0]\n";

Stage play(const std::string& text, int steps) {
    Stage stage(read(text));
    for (int i = 0; i < steps; ++i) EXPECT_TRUE(stage.step());
    return stage;
}

template <class Kind>
Kind kindOf(const std::string& force) {
    const SceneDescription scene = read(kFloor + kBall + "[[force]]\n" + force);
    return std::get<Kind>(scene.forces.at(0).def.kind);
}

TEST(ForceTables, FillInDefaultsAndChooseBodies) {
    const SceneDescription scene = read(
        kFloor + kBall + "[[repeat]]\ncount = 3\nstep = [2, 0, 0]\n"
        "body = { name = 'box{i}', shape = { box = [1, 1, 1] }, at = [5, 1, 0] }\n"
        "[[force]]\ntype = 'wind'\nvelocity = [3, 0, 0]\n"
        "[[force]]\ntype = 'drag'\nlinear = 0.5\non = ['box*', 'ball']\nfrom = 1\nuntil = 2\n"
        "[[force]]\ntype = 'drag'\nangular = 0.5\non = 'box1'\n");
    ASSERT_EQ(scene.forces.size(), 3u);
    EXPECT_EQ(scene.forces[0].def.on.size(), 4u);  // all but the floor
    EXPECT_EQ(scene.forces[0].def.from, 0.0);
    EXPECT_TRUE(std::isinf(scene.forces[0].def.until));
    EXPECT_EQ(scene.forces[1].def.on.size(), 4u);
    EXPECT_EQ(scene.forces[1].def.until, 2.0);
    ASSERT_EQ(scene.forces[2].def.on.size(), 1u);
    EXPECT_EQ(scene.forces[2].def.on[0].index, 3);
}

TEST(ForceTables, ReadEveryType) {
    const auto wind = kindOf<engine::Medium>("type = 'wind'\nvelocity = [1, 2, 3]\ndrag = 0.5\n");
    EXPECT_FALSE(wind.carries);
    EXPECT_EQ(wind.density, 1.2);
    EXPECT_EQ(wind.velocity, Vec3(1, 2, 3));
    const auto water = kindOf<engine::Medium>(
        "type = 'medium'\ndensity = 1000\nlevel = 2\n"
        "within = { from = [-1, -2, -3], to = [1, 2, 3] }\n");
    EXPECT_TRUE(water.carries);
    EXPECT_EQ(water.level, 2.0);
    EXPECT_EQ(water.low, Vec3(-1, -2, -3));
    const auto point = kindOf<engine::PointGravity>(
        "type = 'point-gravity'\nat = [1, 0, 0]\nstrength = 9\nsoftening = 0.1\n");
    EXPECT_EQ(point.strength, 9.0);
    EXPECT_EQ(point.softening, 0.1);
    EXPECT_EQ(kindOf<engine::NBodyGravity>("type = 'n-body-gravity'\n").constant, 6.6743e-11);
    const auto spring = kindOf<engine::SpringForce>(
        "type = 'spring'\na = 'world'\nb = 'ball'\nanchor_a = [0, 5, 0]\nstiffness = 40\n");
    EXPECT_EQ(spring.length, 3.0);  // their distance
    const auto thrust = kindOf<engine::ConstantForce>(
        "type = 'constant'\nforce = [0, 9, 0]\nat = [0, -0.5, 0]\nturn = true\n");
    EXPECT_TRUE(thrust.turns);
    const auto foil = kindOf<engine::Airfoil>(
        "type = 'airfoil'\narea = 0.3\nchord = [2, 0, 0]\nnormal = [1, 1, 0]\nstall_deg = 12\n");
    EXPECT_EQ(foil.chord, Vec3(1, 0, 0));
    EXPECT_LT((foil.normal - Vec3(0, 1, 0)).norm(), 1e-15);
    EXPECT_NEAR(foil.stall, engine::radians(12), 1e-15);
}

TEST(ForceTables, RepeatWithTheirBodies) {
    const SceneDescription scene = read(
        "[[repeat]]\ncount = 3\nstep = [2, 0, 0]\n"
        "body = { name = 'bob{i}', shape = { sphere = 0.1 }, at = [0, 1, 0] }\n"
        "force = { type = 'spring', a = 'world', b = 'bob{i}', anchor_a = [0, 3, 0], "
        "stiffness = 10 }\n");
    ASSERT_EQ(scene.forces.size(), 3u);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(scene.forces[i].def.on[1].index, i);
        const auto& spring = std::get<engine::SpringForce>(scene.forces[i].def.kind);
        EXPECT_EQ(spring.anchorA, Vec3(2 * i, 3, 0));
        EXPECT_NEAR(spring.length, 2.0, 1e-15);
    }
}

// m x'' = -k x from rest at x0: at the other side after half a period
TEST(ForceTables, ASpringToTheWorldSwings) {
    const double period = 2 * engine::kPi * std::sqrt(1.0 / 16.0);
    const Stage stage = play(
        kSpace + "hz = 960\n[[body]]\nname = 'bob'\nshape = { sphere = 0.1 }\nat = [2, 0, 0]\n"
        "mass = 1\n[[force]]\ntype = 'spring'\na = 'world'\nb = 'bob'\nlength = 1\n"
        "stiffness = 16\n",
        static_cast<int>(960 * period / 2 + 0.5));
    EXPECT_NEAR(stage.world.pose(stage.bodies[0]).position.x(), 0.0, 1e-3);
}

const std::string kCart = "[[body]]\nname = 'cart'\nshape = { box = [1, 0.2, 1] }\n";

/// The largest distance of the cart from `at`, over some steps.
template <class Where>
double worstMiss(const std::string& kinematic, int steps, Where at) {
    Stage stage(read(kCart + "kinematic = " + kinematic + "\n"));
    double worst = 0.0;
    for (int i = 1; i <= steps; ++i) {
        EXPECT_TRUE(stage.step());
        const Vec3 miss = stage.world.pose(stage.bodies[0]).position - at(i / 60.0);
        worst = std::max(worst, miss.norm());
    }
    return worst;
}

TEST(KinematicPaths, LandOnEveryPointOfTheirWay) {
    const std::string text = "{ path = [[0, 1, 0], [4, 1, 0], [4, 3, 0], [0, 1, 0]], "
                             "times = [0, 2, 3, 5], loop = true }";
    const auto at = [](double t) -> Vec3 {
        const double s = std::fmod(t, 5.0);
        if (s < 2) return {2 * s, 1, 0};
        if (s < 3) return {4, 1 + 2 * (s - 2), 0};
        return {4 - 2 * (s - 3), 3 - (s - 3), 0};
    };
    EXPECT_LT(worstMiss(text, 900, at), 1e-9);
}

TEST(KinematicPaths, WithoutALoopStayAtTheirEnd) {
    Stage stage(read(kCart + "kinematic = { path = [[0, 1, 0], [1, 1, 0]], times = [0, 0.5] }\n"));
    for (int i = 0; i < 60; ++i) stage.step();
    EXPECT_LT((stage.world.pose(stage.bodies[0]).position - Vec3(1, 1, 0)).norm(), 1e-12);
    EXPECT_LT(stage.world.velocity(stage.bodies[0]).norm(), 1e-12);
}

// Two points, smooth, at rest at both: 3 s^2 - 2 s^3
TEST(KinematicPaths, SmoothOnesStartAndStopAtRest) {
    EXPECT_LT(worstMiss("{ path = [[0, 1, 0], [6, 1, 0]], times = [0, 2], smooth = true }", 120,
                        [](double t) {
                            const double s = t / 2;
                            return Vec3(6 * (3 * s * s - 2 * s * s * s), 1, 0);
                        }),
              1e-12);
}

// A closed smooth path keeps its velocity where it closes.
TEST(KinematicPaths, SmoothLoopsHaveNoCorner) {
    Stage stage(read(
        kCart + "kinematic = { path = [[2, 1, 0], [0, 1, 2], [-2, 1, 0], [0, 1, -2], [2, 1, 0]], "
                "times = [0, 1, 2, 3, 4], smooth = true, loop = true }\n"));
    Vec3 before = Vec3::Zero();
    for (int i = 0; i < 500; ++i) {
        stage.step();
        const Vec3 v = stage.world.velocity(stage.bodies[0]);
        EXPECT_LT(i > 0 ? (v - before).norm() : 0.0, 0.2) << i;
        before = v;
    }
    EXPECT_GT(before.norm(), 1.0);
}

// p = c + r (cos w t, 0, -sin w t), and the body turns like the hand of a clock
TEST(KinematicPaths, OrbitsGoRound) {
    EXPECT_LT(worstMiss("{ orbit = { centre = [1, 2, 0], axis = [0, 3, 0], deg_per_s = 90 } }\n"
                        "at = [4, 2, 0]",
                        480,
                        [](double t) {
                            const double a = engine::kPi / 2 * t;
                            return Vec3(1 + 3 * std::cos(a), 2, -3 * std::sin(a));
                        }),
              1e-9);
    Stage stage(read(kCart + "at = [4, 2, 0]\nkinematic = { orbit = { centre = [1, 2, 0], "
                             "deg_per_s = 90 } }\n"));
    for (int i = 0; i < 60; ++i) stage.step();
    const Vec3 nose = stage.world.pose(stage.bodies[0]).rotation * Vec3(1, 0, 0);
    EXPECT_LT((nose - Vec3(0, 0, -1)).norm(), 1e-4);
}

TEST(KinematicPaths, CarryWhatStandsOnThem) {
    const Stage stage = play(
        kCart + "kinematic = { path = [[0, 1, 0], [2, 1, 0]], times = [0, 4], smooth = true }\n"
        "[[body]]\nname = 'load'\nshape = { box = [0.4, 0.4, 0.4] }\nat = [0, 1.3, 0]\n",
        270);
    EXPECT_NEAR(stage.world.pose(stage.bodies[1]).position.x(), 2.0, 0.01);
}

TEST(GroupNames, BecomeBits) {
    const SceneDescription scene = read(
        kFloor + kBall + "group = ['a', 'b']\n[[body]]\nname = 'box'\nshape = { box = [1, 1, 1] }\n"
        "at = [0, 2, 0]\ngroup = 'c'\nignores = ['b']\n");
    EXPECT_EQ(scene.bodies[0].def.groups, 0u);
    EXPECT_EQ(scene.bodies[1].def.groups, 3u);
    EXPECT_EQ(scene.bodies[2].def.groups, 4u);
    EXPECT_EQ(scene.bodies[2].def.ignores, 2u);
}

TEST(Events, OfASensorAndAFloorAsJson) {
    Stage stage(read(kFloor + kBall + "[[body]]\nname = 'gate'\nsensor = true\nfixed = true\n"
                                      "shape = { box = [4, 0.1, 4] }\nat = [0, 1, 0]\n"));
    stage.world.watchTouches(true);
    EventLog log, last;
    for (int i = 0; i < 120; ++i) {
        stage.step();
        if (i % 2 == 0) last.clear();
        log.look(stage), last.look(stage);
    }
    // The ball touches the gate, in which it stays, and the floor.
    ASSERT_EQ(log.events().touches.size(), 2u);
    EXPECT_EQ(last.events().size(), 0u);
    const std::string json = eventsJson(log.events(), stage);
    EXPECT_EQ(json.find("[\n {\"event\":\"begin\",\"step\":"), 0u) << json;
    const auto tells = [&json](const char* what) { return json.find(what) != std::string::npos; };
    EXPECT_TRUE(tells(R"("a":"ball","b":"gate","sensor":true)")) << json;
    EXPECT_TRUE(tells(R"("a":"floor","b":"ball","sensor":false)")) << json;
    EXPECT_EQ(eventsJson({}, stage), "[]");
}

}  // namespace
}  // namespace demos::test
