// MuJoCo's models in motion, compared with formulas.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/demos/mjcf/mjcf_reading.h"

namespace demos::test {
namespace {

using engine::JointType;

constexpr double kG = 9.81;
const std::string kNoWeight = "<option gravity='0 0 0'/>\n";

std::string world(const std::string& inside) {
    return "<worldbody>" + inside + "</worldbody>";
}

/// s, between every second zero crossing of the first joint's angle.
double periodOf(Stage& stage, double seconds) {
    std::vector<double> zeros;
    double before = stage.world.joint(stage.joints[0]).position;
    for (int i = 1; i <= static_cast<int>(seconds * stage.scene.hz); ++i) {
        EXPECT_TRUE(stage.step());
        const double now = stage.world.joint(stage.joints[0]).position;
        const double middle = 0.5 * engine::kPi;  // hanging down
        if ((before < middle) != (now < middle))
            zeros.push_back((i - 1 + (middle - before) / (now - before)) * stage.dt());
        before = now;
    }
    return zeros.size() < 3 ? 0.0 : zeros[2] - zeros[0];
}

TEST(MujocoMotion, APendulumReleasedFromLevelHasItsPeriod) {
    // T = 4 K(sin^2 45 deg) sqrt(I / (m g l)), I = m l^2 + 2/5 m r^2, as of demos/scenes/pendulum.toml
    Stage stage(readMujoco("<option timestep='0.002'/>" +
                           world("<body pos='0 0 2'><joint name='pin' axis='0 1 0'/>"
                                 "<geom type='sphere' size='0.12' pos='1 0 0' mass='1'/></body>")));
    const double period = 4.0 * 1.854074677301372 * std::sqrt((1.0 + 0.4 * 0.12 * 0.12) / kG);
    EXPECT_NEAR(periodOf(stage, 6.0), period, 1e-3);
    EXPECT_EQ(stage.scene.joints[0].name, "pin");
}

TEST(MujocoMotion, ADoublePendulumKeepsItsEnergy) {
    Stage stage(readMujoco(
        "<default><geom type='capsule' size='0.02' density='1000'/><joint axis='0 1 0'/></default>" +
        world("<body pos='0 0 2'><joint/><geom fromto='0 0 0 0.5 0 0'/>"
              "<body pos='0.5 0 0'><joint/><geom fromto='0 0 0 0.5 0 0'/></body></body>")));
    ASSERT_EQ(stage.scene.joints.size(), 2u);
    EXPECT_EQ(stage.scene.joints[1].def.a.index, 0);
    const double before = stage.world.energy().total();
    double farthest = 0.0;
    for (int i = 0; i < 4 * stage.scene.hz; ++i) {
        ASSERT_TRUE(stage.step());
        farthest = std::max(farthest, std::abs(stage.world.energy().total() - before));
    }
    const double scale = 2.0 * *stage.scene.bodies[0].def.mass * kG * 0.5;  // J, of falling by half a rod
    EXPECT_LT(farthest, 0.01 * scale);
}

TEST(MujocoMotion, DampingLetsASlideFallAtMgOverC) {
    Stage stage(readMujoco(world("<body><joint type='slide' axis='0 0 1' damping='20'/>"
                                 "<geom size='0.1' mass='4'/></body>")));
    playFor(3.0, stage);  // 15 time constants m / c
    EXPECT_NEAR(stage.world.velocity(stage.bodies[0]).y(), -4.0 * kG / 20.0, 1e-5);
    EXPECT_NEAR(stage.world.joint(stage.joints[0]).speed, -4.0 * kG / 20.0, 1e-5);
}

TEST(MujocoMotion, AStiffHingeSwingsAtTheRootOfKOverI) {
    // 3 kg 0.5 m from the hinge: w^2 = k / I = 12 / 0.75; half a period after rest it is at 2 rest
    Stage stage(readMujoco("<compiler angle='radian'/>" + kNoWeight +
                           world("<body><joint axis='0 0 1' stiffness='12' springref='0.2'/>"
                                 "<geom size='0.001' pos='0.5 0 0' mass='3'/></body>")));
    playFor(engine::kPi / 4.0, stage);
    EXPECT_NEAR(stage.world.joint(stage.joints[0]).position, 0.4, 3e-3);  // implicit: a little damped
}

TEST(MujocoMotion, RangesAreCountedFromRef) {
    // In the file the hinge is at 30 degrees already; it may go to 45.
    Stage stage(readMujoco(world("<body><joint axis='0 1 0' ref='30' range='0 45' damping='0.3'/>"
                                 "<geom size='0.05' pos='1 0 0' mass='1'/></body>")));
    playFor(2.0, stage);
    EXPECT_NEAR(stage.world.joint(stage.joints[0]).position, engine::radians(15.0), 1e-3);
    const SceneDescription free = readMujoco(
        "<compiler autolimits='false'/>" + world("<body><joint range='0 45'/><geom size='1'/></body>"));
    EXPECT_FALSE(free.joints[0].def.free[0].limits.any());
}

TEST(MujocoMotion, FrictionlossHoldsWhatIsLighter) {
    const auto speedWith = [](const std::string& mass) {
        Stage stage(readMujoco(world("<body><joint type='slide' axis='0 0 1' frictionloss='10'/>"
                                     "<geom size='0.1' mass='" + mass + "'/></body>")));
        for (int i = 0; i < 540; ++i) EXPECT_TRUE(stage.step());
        return stage.world.velocity(stage.bodies[0]).y();
    };
    EXPECT_NEAR(speedWith("1"), 0.0, 1e-6);             // m g = 9.81 N
    EXPECT_NEAR(speedWith("2"), -(kG - 10.0 / 2.0), 1e-3);  // a = g - F / m, for a second
}

TEST(MujocoMotion, TwoHingesTurnOneAfterTheOther) {
    // Springs bring them to 0.5 about x and 0.3 about -y of the body as it is turned by then.
    Stage stage(readMujoco(
        "<compiler angle='radian'/>" + kNoWeight +
        world("<body><joint name='x' axis='1 0 0' stiffness='50' springref='0.5' damping='5'/>"
              "<joint name='y' axis='0 -1 0' stiffness='50' springref='0.3' damping='5'/>"
              "<geom type='box' size='0.3 0.2 0.1' density='500'/></body>")));
    ASSERT_EQ(stage.scene.joints.at(0).def.type, JointType::universal);
    EXPECT_EQ(stage.scene.joints[0].name, "x+y");
    EXPECT_TRUE(stage.scene.notes.empty()) << listed(stage.scene.notes);
    playFor(4.0, stage);
    const Quat turn = engine::turnAbout(Vec3::UnitX(), 0.5) *
                      engine::turnAbout(Vec3(0, 0, 1), 0.3);  // MuJoCo's -y
    expectNear(stage.world.pose(stage.bodies[0]).rotation * Vec3(1, 2, 3), turn * Vec3(1, 2, 3), 1e-3);
}

TEST(MujocoMotion, SlidesThenAHingeAreAPlanarJoint) {
    Stage stage(readMujoco(
        "<compiler angle='radian'/>" + kNoWeight +
        world("<body pos='0 0 1'><joint type='slide' axis='1 0 0' stiffness='50' springref='0.4' "
              "damping='30'/><joint type='slide' axis='0 0 -1' stiffness='50' springref='0.2' damping='30'/>"
              "<joint axis='0 1 0' pos='0.1 0 0' stiffness='50' springref='0.7' damping='30'/>"
              "<geom type='box' size='0.2 0.2 0.2' density='100'/></body>")));
    const engine::JointDef& def = stage.scene.joints.at(0).def;
    ASSERT_EQ(def.type, JointType::sixDof);
    EXPECT_EQ(stage.scene.notes, std::vector<std::string>{});
    playFor(6.0, stage);
    // The hinge's point goes by (0.4, 0, -0.2), and the body turns about it by 0.7 about MuJoCo's y.
    const Quat turn = engine::turnAbout(Vec3(0, 0, -1), 0.7);
    const Vec3 centre = Vec3(0.1, 1.0, 0) + Vec3(0.4, -0.2, 0) + turn * Vec3(-0.1, 0, 0);
    expectNear(stage.world.pose(stage.bodies[0]).position, centre, 1e-3);
    expectNear(stage.world.pose(stage.bodies[0]).rotation * Vec3(1, 0, 0), turn * Vec3(1, 0, 0), 1e-3);
}

TEST(MujocoMotion, ThreeHingesAreABallWhoseTurnsAreReported) {
    const SceneDescription scene = readMujoco(world(
        "<body><joint axis='1 0 0' range='-10 20'/><joint axis='0 0 1'/><joint axis='0 1 0'/>"
        "<geom type='box' size='1 1 1'/></body>"));
    const engine::JointDef& def = scene.joints.at(0).def;
    ASSERT_EQ(def.type, JointType::sixDof);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(def.free[i].locked);
    for (int i = 3; i < 6; ++i) EXPECT_FALSE(def.free[i].locked);
    EXPECT_NEAR(def.free[3].limits.high, engine::radians(20.0), 1e-12);
    EXPECT_TRUE(tells(scene.notes, "a.xml:2:", "several hinges of a <body>")) << listed(scene.notes);
}

TEST(MujocoMotion, BodiesHangOnTheWorldAndFallOnItsGeoms) {
    // A jointed body collides with the world's geoms, as in MuJoCo, but not with its own parent.
    Stage stage(readMujoco(world(
        "<geom type='plane' size='1 1 1'/><body pos='0 0 0.5'><joint axis='0 1 0' damping='1'/>"
        "<geom type='capsule' size='0.05' fromto='0 0 0 1 0 0'/>"
        "<body pos='1 0 0'><joint type='ball'/><geom size='0.06' mass='0.1'/></body></body>")));
    playFor(4.0, stage);
    const double angle = stage.world.joint(stage.joints[0]).position;
    EXPECT_GT(angle, 0.3);
    EXPECT_LT(angle, 0.6);  // asin((0.5 - 0.06) / 1) or so: it lies on the plane
    EXPECT_LT(stage.world.joint(stage.joints[1]).separation, 1e-3);
}

TEST(MujocoMotion, ConnectAndWeldHold) {
    Stage stage(readMujoco(
        world("<body name='a' pos='0 0 1'><freejoint/><geom size='0.1' mass='1'/></body>"
              "<body name='b' pos='1 0 1'><freejoint/><geom size='0.1' mass='1'/></body>"
              "<body name='c' pos='2 0 1'><freejoint/><geom size='0.1' mass='1'/></body>") +
        "<equality><connect body1='a' anchor='0 0 1'/><weld body1='a' body2='b'/>"
        "<weld body1='b' body2='c' active='false'/></equality>"));
    ASSERT_EQ(stage.scene.joints.size(), 2u);
    playFor(0.5, stage);
    const Vec3 pin(0, 2, 0);
    const Vec3 a = stage.world.pose(stage.bodies[0]).position;
    EXPECT_NEAR((a - pin).norm(), 1.0, 1e-4);
    EXPECT_NEAR((a - stage.world.pose(stage.bodies[1]).position).norm(), 1.0, 1e-4);
    EXPECT_NEAR(stage.world.pose(stage.bodies[2]).position.y(), 1.0 - 0.5 * kG * 0.25, 5e-3);
}

TEST(MujocoMotion, AMocapBodyStandsAndIsReported) {
    const SceneDescription scene =
        readMujoco(world("<body mocap='true' pos='0 0 1'><geom size='0.1'/></body>"));
    EXPECT_EQ(scene.bodies.at(0).def.kind, engine::BodyKind::fixed);
    EXPECT_TRUE(tells(scene.notes, "a.xml:2:", "a mocap <body>")) << listed(scene.notes);
}

}  // namespace
}  // namespace demos::test
