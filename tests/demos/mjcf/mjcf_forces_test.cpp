// MuJoCo's actuators, tendons, rotors and friction, compared with formulas.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/demos/mjcf/mjcf_reading.h"

namespace demos::test {
namespace {

constexpr double kWeight = 9.81;  // N, of a kilogram
const std::string kRadians = "<compiler angle='radian'/><option gravity='0 0 0'/>\n";

/// A slide of 4 kg along x, and a wheel that turns about y: m a^2 2/5 = 0.016 kg m^2.
const std::string kCart =
    "<worldbody><body><joint name='way' type='slide' axis='1 0 0'/><geom size='0.1' mass='4'/></body>"
    "<body pos='0 1 0'><joint name='turn' axis='0 1 0' ref='0.5'/><geom size='0.1' mass='4'/></body>"
    "</worldbody>";

/// Positions and speeds of the two joints after some time.
struct Ways {
    double way, turn, wayRate, turnRate;
};

Ways after(double seconds, const std::string& rest) {
    Stage stage(readMujoco(kRadians + kCart + rest));
    playFor(seconds, stage);
    const engine::JointState way = stage.world.joint(stage.joints[0]);
    const engine::JointState turn = stage.world.joint(stage.joints[1]);
    return {way.position, turn.position, way.speed, turn.speed};
}

std::string actuated(const std::string& actuators, const std::string& control) {
    return "<actuator>" + actuators + "</actuator><keyframe><key ctrl='" + control + "'/></keyframe>";
}

TEST(MujocoFriction, IsThatOfTheLargerCondimAndTheLargerNumber) {
    const auto wayOf = [](const std::string& floor, const std::string& box) {
        Stage stage(readMujoco("<worldbody><geom type='plane' size='9 9 1' euler='0 20 0' " + floor +
                               "/><body pos='0.0342 0 0.09397' euler='0 20 0'><freejoint/>"
                               "<geom type='box' size='0.1 0.1 0.1' " + box + "/></body></worldbody>"));
        playFor(1.0, stage);
        return stage.world.pose(stage.bodies[1]).position.x() - 0.0342;
    };
    const auto slid = [](double mu) {  // g (sin - mu cos) t^2 / 2, as seen from above
        const double angle = engine::radians(20.0), c = engine::cosine(angle);
        return 0.5 * kWeight * (engine::sine(angle) - mu * c) * c;
    };
    EXPECT_NEAR(wayOf("condim='3' friction='0.1'", "condim='1' friction='0.2'"), slid(0.2), 3e-3);
    EXPECT_NEAR(wayOf("condim='1' friction='0.7'", "condim='3' friction='0.1'"), 0.0, 1e-3);
    EXPECT_NEAR(wayOf("condim='1'", "condim='1'"), slid(0.0), 3e-3);
    EXPECT_NEAR(wayOf("friction='0.9'", "friction='0.1' priority='1'"), slid(0.1), 3e-3);
}

TEST(MujocoArmature, SlowsWhatItIsGearedTo) {
    Stage stage(readMujoco("<worldbody><body><joint type='slide' axis='0 0 1' armature='6'/>"
                           "<geom size='0.1' mass='4'/></body></worldbody>"));
    EXPECT_TRUE(stage.scene.notes.empty()) << listed(stage.scene.notes);
    playFor(1.0, stage);
    EXPECT_NEAR(stage.world.velocity(stage.bodies[0]).y(), -0.4 * kWeight, 1e-3);  // m g / (m + I)
}

TEST(MujocoActuators, MotorsPushWithTheirGearAndRange) {
    const Ways moved = after(1.0, actuated("<motor joint='way' gear='2' ctrlrange='-3 3'/>"
                                           "<motor joint='turn' forcerange='-0.004 1'/>", "9 -5"));
    EXPECT_NEAR(moved.wayRate, 2.0 * 3.0 / 4.0, 1e-6);    // gear ctrl t / m
    EXPECT_NEAR(moved.turnRate, -0.004 / 0.016, 1e-6);
}

TEST(MujocoActuators, RestWithoutAControl) {
    const Ways moved = after(0.5, "<actuator><motor joint='way'/></actuator>");
    EXPECT_EQ(moved.wayRate, 0.0);
    const Ways off = after(0.5, "<option><flag actuation='disable'/></option>" +
                                    actuated("<motor joint='way'/>", "3"));
    EXPECT_EQ(off.wayRate, 0.0);
}

TEST(MujocoActuators, PositionsPullLikeSprings) {
    // Half a period after rest the cart is at twice its control: w^2 = kp / m.
    const Ways half = after(engine::kPi / 2.0, actuated("<position joint='way' kp='16'/>", "0.3"));
    EXPECT_NEAR(half.way, 0.6, 3e-3);
    // With damping it settles where MuJoCo's coordinate, which starts at ref, equals the control.
    const Ways held = after(3.0, actuated("<position joint='turn' kp='2' kv='0.2'/>", "0.8"));
    EXPECT_NEAR(held.turn, 0.3, 1e-4);
}

TEST(MujocoActuators, VelocitiesAndGeneralOnesAreAffine) {
    const Ways fast = after(4.0, actuated("<velocity joint='way' kv='8'/>"
                                          "<general joint='turn' gainprm='2' biastype='affine' "
                                          "biasprm='0.3 -1 -0.2'/>", "1.5 0.25"));
    EXPECT_NEAR(fast.wayRate, 1.5 * (1.0 - std::exp(-8.0)), 1e-3);  // kv t / m = 8
    EXPECT_NEAR(fast.turn, 0.3, 1e-4);  // 2 ctrl + 0.3 - q = 0, q = 0.8 = turn + ref
    const Ways damped = after(2.0, "<actuator><damper joint='way' kv='8'/></actuator>"
                                   "<keyframe><key ctrl='1'/></keyframe>");
    EXPECT_EQ(damped.wayRate, 0.0);
}

TEST(MujocoActuators, TakeWhatTheirKindDoesNotSayFromGeneral) {
    const std::string defaults =
        "<default><general gear='5' ctrlrange='-1 1'/><motor gear='3'/></default>";
    const Ways moved = after(1.0, defaults + actuated("<motor joint='way'/>", "4"));
    EXPECT_NEAR(moved.wayRate, 3.0 / 4.0, 1e-6);
}

TEST(MujocoTendons, OfJointsAreForcesAlongThem) {
    const Ways pulled = after(1.0, "<tendon><fixed name='t'><joint joint='way' coef='2'/>"
                                   "<joint joint='turn' coef='-0.01'/></fixed></tendon>" +
                                       actuated("<motor tendon='t'/>", "0.8"));
    EXPECT_NEAR(pulled.wayRate, 2.0 * 0.8 / 4.0, 1e-6);
    EXPECT_NEAR(pulled.turnRate, -0.01 * 0.8 / 0.016, 1e-6);
    const Ways sprung = after(4.0, "<tendon><fixed stiffness='20' damping='10' springlength='0.6'>"
                                   "<joint joint='way' coef='2'/></fixed></tendon>");
    EXPECT_NEAR(sprung.way, 0.3, 1e-4);  // 2 q = 0.6
}

const std::string kHung =
    "<worldbody><site name='hook' pos='0 0 2'/><body pos='0 0 1.5'><freejoint/>"
    "<geom size='0.1' mass='2'/><site name='eye' pos='0 0 0.1'/></body></worldbody>";

TEST(MujocoTendons, BetweenTwoSitesAreCordsOrSprings) {
    const auto heightOf = [](const std::string& attributes) {
        Stage stage(readMujoco(kHung + "<tendon><spatial " + attributes +
                               "><site site='hook'/><site site='eye'/></spatial></tendon>"));
        playFor(4.0, stage);
        return stage.world.pose(stage.bodies[0]).position.y();
    };
    EXPECT_NEAR(heightOf("range='0 0.7'"), 2.0 - 0.7 - 0.1, 1e-3);
    EXPECT_NEAR(heightOf("stiffness='100' damping='20' springlength='0.3'"),
                2.0 - 0.3 - 2.0 * kWeight / 100.0 - 0.1, 1e-3);
    EXPECT_NEAR(heightOf("stiffness='100' damping='20'"), 1.5 - 2.0 * kWeight / 100.0, 1e-3);
}

TEST(MujocoForces, NoteWhatIsLeftOut) {
    const auto said = [](const std::string& rest, const std::string& text) {
        const std::vector<std::string> notes = readMujoco(kCart + rest).notes;
        EXPECT_TRUE(tells(notes, "a.xml:", text)) << rest << "\n" << listed(notes);
    };
    const auto acting = [](const std::string& actuator) {
        return "<actuator>" + actuator + "</actuator>";
    };
    said(acting("<general joint='way' dyntype='filter'/>"),
         "an actuator with activation dynamics (dyntype filter) is not supported; left out");
    said(acting("<general joint='way' gaintype='muscle'/>"),
         "gaintype muscle of an actuator is not supported; replaced by fixed");
    said(acting("<position joint='way' forcerange='-1 1'/>"),
         "forcerange of an actuator whose force is not constant is not supported; left out");
    said(acting("<position joint='way' kp='-1'/>"), "an actuator that makes stiffness or damping negative");
    said(acting("<motor site='s'/>"), "<motor site> is not supported; left out");
    said("<keyframe><key qpos='1 2'/></keyframe>", "<key qpos> is not supported; left out");
    said("<tendon><fixed stiffness='1'><joint joint='way'/><joint joint='turn'/></fixed></tendon>",
         "a <fixed> tendon of several joints with a spring");
    said("<tendon><fixed range='0 1'><joint joint='way'/></fixed></tendon>",
         "range of a <fixed> tendon is not supported; left out");
    const std::vector<std::string> ball = readMujoco(
        "<worldbody><body><joint name='b' type='ball' armature='1'/><geom size='1'/></body></worldbody>" +
        acting("<motor joint='b'/>")).notes;
    EXPECT_TRUE(tells(ball, "a.xml:", "an actuator of a ball joint is not supported")) << listed(ball);
    EXPECT_TRUE(tells(ball, "a.xml:", "armature of a ball joint is not supported")) << listed(ball);
    for (const char* joint : {"<freejoint name='f'/>", "<joint name='f' type='free'/>"}) {
        const std::vector<std::string> free =
            readMujoco("<worldbody><body>" + std::string(joint) + "<geom size='1'/></body></worldbody>" +
                       acting("<motor joint='f'/>")).notes;
        EXPECT_TRUE(tells(free, "a.xml:", "an actuator of a free joint is not supported; left out"))
            << listed(free);
    }
}

TEST(MujocoForces, OfWrongNamesAreErrors) {
    const auto wrong = [](const std::string& rest, const std::string& text) {
        const std::vector<std::string> lines =
            modelErrors("<mujoco>" + kCart + rest + "</mujoco>");
        EXPECT_TRUE(tells(lines, "a.xml:1:", text)) << listed(lines);
    };
    wrong("<actuator><motor joint='wey'/></actuator>",
          "no joint is called 'wey'; did you mean 'way'?");
    wrong("<actuator><motor tendon='t'/></actuator>", "no tendon is called 't'");
    wrong("<actuator><motor joint='way' ctrlrange='1 -1'/></actuator>",
          "ctrlrange is '1 -1'; it should be two numbers, the lower one first");
    wrong("<tendon><fixed><joint joint='wey'/></fixed></tendon>", "did you mean 'way'?");
    wrong("<tendon><spatial range='0 1'><site site='a'/><site site='b'/></spatial></tendon>",
          "no site is called 'a'");
}

}  // namespace
}  // namespace demos::test
