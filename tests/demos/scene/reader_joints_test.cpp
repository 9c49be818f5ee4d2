// Every type of joint in a scene file: its values reach the engine, and it holds.

#include <gtest/gtest.h>

#include <numbers>

#include "demos/play/stage.h"
#include "demos/scene/joint_kinds.h"
#include "tests/demos/reading.h"

namespace demos::test {
namespace {

using engine::JointDef;
using engine::JointType;

constexpr double kDegree = std::numbers::pi / 180.0;

const std::string kBox =
    "[[body]]\nname = 'box'\nshape = { box = [0.6, 0.3, 0.4] }\nat = [1, 2, 0]\n";
const std::string kOther =
    "[[body]]\nname = 'other'\nshape = { box = [0.4, 0.3, 0.4] }\nat = [2, 2, 0]\n";

std::string joint(const std::string& type, const std::string& keys) {
    return kBox + kOther + "[[joint]]\ntype = '" + type + "'\na = 'world'\nb = 'box'\n" + keys;
}

JointDef defOf(const std::string& type, const std::string& keys) {
    return read(joint(type, keys)).joints.at(0).def;
}

/// A joint of every type to the world, which the box satisfies at the start.
struct Hung {
    const char* type;
    std::string keys;
};

const std::string kAt = "anchor = [1, 2.4, 0.1]\n", kAxis = "axis = [0, 0, 1]\n";
const std::string kAcross = "axis2 = [1, 0, 0]\n";

std::vector<Hung> hung() {
    return {
        {"ball", kAt + kAxis + "twist_deg = [-20, 20]\nswing_deg = 30\n"},
        {"distance", "anchor_a = [1, 4, 0]\n"},
        {"hinge", kAt + kAxis + "limits_deg = [-10, 400]\nmotor = { speed = 1, max = 2 }\n"},
        {"weld", kAt},
        {"slider", kAt + "axis = [0, 1, 0]\nlimits = [-0.2, 0.1]\n"},
        {"universal", kAt + kAxis + kAcross},
        {"constant-velocity", kAt + "axis = [0, 1, 0]\nswing_deg = 20\n"},
        {"look-at", "anchor_a = [1, 4, 0]\naxis = [0, 1, 0]\n"},
        {"axis", kAxis},
        {"six-dof", kAt + "x = 'locked'\ny = { limits = [-0.3, 0.3] }\nz = 'locked'\n"},
        {"gear", "axis = [0, 1, 0]\nratio = 2\n"},
        {"wheel", kAt + "axis = [0, 1, 0]\n" + kAcross + "limits = [-0.2, 0.2]\n"},
        {"path", "points = [[0, 2.1, 0], [1, 2, 0], [2, 2.1, 0.3]]\n"},
    };
}

TEST(ReaderJoints, OfEveryTypeHoldForASecond) {
    std::size_t number = 0;
    for (const Hung& h : hung()) {
        SCOPED_TRACE(h.type);
        Stage stage(read(joint(h.type, h.keys)));
        ASSERT_EQ(stage.world.joint(stage.joints[0]).def.type, jointKinds()[number++].type);
        double worst = 0.0, reach = 0.0;
        for (int i = 0; i < 60; ++i) {
            ASSERT_TRUE(stage.step());
            worst = std::max(worst, stage.world.joint(stage.joints[0]).separation);
            reach = std::max(reach, stage.world.velocity(stage.bodies[0]).norm());
        }
        EXPECT_LT(worst, 2e-3);  // m
        EXPECT_LT(reach, 10.0);  // m/s: a second of falling, and no explosion
    }
    EXPECT_EQ(number, jointKinds().size());
}

TEST(ReaderJoints, ReadLimitsMotorAndSpring) {
    const JointDef hinge =
        defOf("hinge", kAt + kAxis +
                           "limits_deg = [-90, 720]\nmotor = { speed = 3, max = 50 }\n"
                           "spring = { hz = 2, damping = 0.5, rest_deg = 10 }\n"
                           "soft = { hz = 30 }\n");
    EXPECT_NEAR(hinge.free[0].limits.low, -90.0 * kDegree, 1e-15);
    EXPECT_NEAR(hinge.free[0].limits.high, 720.0 * kDegree, 1e-14);
    EXPECT_EQ(hinge.free[0].motor.speed, 3.0);
    EXPECT_EQ(hinge.free[0].motor.strength, 50.0);
    EXPECT_EQ(hinge.free[0].spring.hz, 2.0);
    EXPECT_EQ(hinge.free[0].spring.damping, 0.5);
    EXPECT_NEAR(hinge.free[0].rest, 10.0 * kDegree, 1e-15);
    EXPECT_EQ(hinge.spring.hz, 30.0);

    const JointDef slider = defOf("slider", kAt + kAxis +
                                                "limits = [-0.5, 1]\nmotor = { speed = -1 }\n"
                                                "spring = { hz = 1, rest = 0.25 }\nbreak_at = 500\n"
                                                "break_torque = 60\n");
    EXPECT_EQ(slider.free[0].limits.low, -0.5);
    EXPECT_EQ(slider.free[0].motor.strength, engine::kUnlimited);
    EXPECT_EQ(slider.free[0].rest, 0.25);
    EXPECT_FALSE(slider.spring.isSoft());
    EXPECT_EQ(slider.breakForce, 500.0);
    EXPECT_EQ(slider.breakTorque, 60.0);
    EXPECT_EQ(defOf("weld", kAt).breakForce, engine::kUnlimited);
}

TEST(ReaderJoints, ReadTheTwoAnglesOfABallAndAUniversalJoint) {
    const JointDef ball = defOf("ball", kAt + kAxis + "twist_deg = [-10, 20]\nswing_deg = 30\n");
    EXPECT_NEAR(ball.free[0].limits.high, 20.0 * kDegree, 1e-15);
    EXPECT_EQ(ball.free[1].limits.low, -engine::kUnlimited);
    EXPECT_NEAR(ball.free[1].limits.high, 30.0 * kDegree, 1e-15);
    const JointDef universal =
        defOf("universal", kAt + kAxis + kAcross +
                               "limits_deg = [-1, 2]\nlimits2_deg = [-3, 4]\n"
                               "motor = { speed = 5 }\n"
                               "motor2 = { speed = 6, max = 7 }\n");
    EXPECT_NEAR(universal.free[0].limits.low, -1.0 * kDegree, 1e-15);
    EXPECT_NEAR(universal.free[1].limits.high, 4.0 * kDegree, 1e-15);
    EXPECT_EQ(universal.free[0].motor.speed, 5.0);
    EXPECT_EQ(universal.free[1].motor.strength, 7.0);
    EXPECT_EQ(universal.axis2, Vec3(1, 0, 0));
}

TEST(ReaderJoints, AWheelRidesOnItsSpringAndSpinsByItsMotor) {
    const JointDef wheel =
        defOf("wheel", kAt + "axis = [0, 2, 0]\n" + kAcross +
                           "limits = [-0.1, 0.2]\n"
                           "spring = { hz = 3, damping = 0.4 }\nmotor = { speed = 8, max = 9 }\n");
    EXPECT_EQ(wheel.axis, Vec3(0, 1, 0));
    EXPECT_EQ(wheel.free[0].limits.high, 0.2);
    EXPECT_EQ(wheel.free[0].spring.hz, 3.0);
    EXPECT_FALSE(wheel.free[0].motor.isOn());
    EXPECT_EQ(wheel.free[1].motor.speed, 8.0);
    EXPECT_EQ(wheel.free[1].motor.strength, 9.0);
}

TEST(ReaderJoints, SixDofReadsEachCoordinate) {
    const JointDef six =
        defOf("six-dof", kAt +
                             "axis = [0, 1, 0]\naxis2 = [0, 0, 1]\nx = 'locked'\ny = 'free'\n"
                             "z = { limits = [-1, 2], motor = { speed = 3 } }\nrx = 'locked'\n"
                             "rz = { limits_deg = [-5, 5], spring = { hz = 4, rest_deg = 1 } }\n");
    EXPECT_TRUE(six.free[0].locked);
    EXPECT_FALSE(six.free[1].locked);
    EXPECT_FALSE(six.free[1].acts());
    EXPECT_EQ(six.free[2].limits.high, 2.0);
    EXPECT_EQ(six.free[2].motor.speed, 3.0);
    EXPECT_TRUE(six.free[3].locked);
    EXPECT_FALSE(six.free[4].locked);
    EXPECT_EQ(six.free[5].spring.hz, 4.0);
    EXPECT_NEAR(six.free[5].rest, kDegree, 1e-15);
    EXPECT_EQ(six.axis2, Vec3(0, 0, 1));
}

TEST(ReaderJoints, DistancesHaveALengthOfTheirOwn) {
    EXPECT_EQ(defOf("distance", "anchor_a = [1, 5, 0]\n").length, 3.0);
    const JointDef rope = defOf("distance",
                                "anchor_a = [1, 5, 0]\nlength = 2.5\n"
                                "limits = [0, 4]\nspring = { hz = 2 }\n");
    EXPECT_EQ(rope.length, 2.5);
    EXPECT_EQ(rope.free[0].limits.high, 4.0);
    EXPECT_EQ(rope.spring.hz, 2.0);
    // A length of 0 at the start is allowed with limits only.
    EXPECT_EQ(defOf("distance", "anchor_a = [1, 2, 0]\nlimits = [0, 1]\n").length, 0.0);
}

TEST(ReaderJoints, GearsAndPaths) {
    const JointDef gear = defOf("gear", "axis = [0, 1, 0]\naxis2 = [0, 0, 3]\nratio = -2.5\n");
    EXPECT_EQ(gear.ratio, -2.5);
    EXPECT_EQ(gear.axis2, Vec3(0, 0, 1));
    const JointDef path =
        defOf("path",
              "points = [[1, 2, 0], [2, 2, 0], [2, 3, 0]]\nclosed = true\n"
              "limits = [0, 2]\nmotor = { speed = 1, max = 2 }\nanchor_b = [0.1, 0, 0]\n");
    EXPECT_TRUE(path.closed);
    EXPECT_EQ(path.path.at(2), Vec3(2, 3, 0));
    EXPECT_EQ(path.free[0].limits.high, 2.0);
    EXPECT_EQ(path.free[0].motor.strength, 2.0);
    EXPECT_EQ(path.anchorB, Vec3(0.1, 0, 0));
}

/// A [[repeat]] moves points of the world, but not those of a body.
TEST(ReaderJoints, OfARepeatAreMoved) {
    const SceneDescription scene = read(
        "[[repeat]]\ncount = 2\nstep = [3, 0, 0]\nbody = { name = 'b{i}', shape = { sphere = 0.1 } "
        "}\n"
        "joint = { type = 'path', a = 'world', b = 'b{i}', points = [[0, 0, 0], [1, 0, 0]] }\n");
    EXPECT_EQ(scene.joints.at(1).def.path.at(1), Vec3(4, 0, 0));
}

struct BadJoint {
    const char* type;
    std::string keys;
    const char* message;
};

TEST(ReaderJoints, ComplainOfWhatIsWrong) {
    const BadJoint bad[] = {
        {"weld", kAt + "limits = [0, 1]\n",
         "a weld joint has no limits; leave it out, or make it distance, slider, wheel or path"},
        {"slider", kAt + kAxis + "limits_deg = [0, 1]\n", "make it hinge, universal or axis"},
        {"hinge", kAt + kAxis + "x = 'locked'\n",
         "a hinge joint has no x; leave it out, or make "
         "it six-dof"},
        {"axis", kAxis + "anchor = [0, 0, 0]\n", "an axis joint has no anchor"},
        {"slider", kAt, "a slider joint has no axis; write axis = [0, 0, 1]"},
        {"gear", kAxis, "a gear joint has no ratio; write ratio = -2"},
        {"path", "", "a path joint has no points; write points = [["},
        {"hinge", kAt + kAxis + "limits_deg = [10, -10]\n",
         "limits_deg should be two numbers, the lower one first, like [-45, 45] (deg)"},
        {"slider", kAt + kAxis + "limits = [1]\n", "like [-0.5, 0.5] (m)"},
        {"hinge", kAt + kAxis + "motor = { max = 3 }\n", "in rad/s and N m"},
        {"slider", kAt + kAxis + "motor = {}\n", "in m/s and N"},
        {"hinge", kAt + kAxis + "motor = { speed = 1, max = 0 }\n", "max is 0; it should be"},
        {"hinge", kAt + kAxis + "spring = { hz = 1, rest = 1 }\n",
         "unknown key 'rest' in a spring"},
        {"hinge", kAt + kAxis + "spring = { rest_deg = 1 }\n", "a spring has no frequency"},
        {"ball", kAt + "swing_deg = 10\n", "twist_deg and swing_deg need an axis"},
        {"ball", kAt + kAxis + "swing_deg = 200\n", "swing_deg is 200; it should be"},
        {"universal", kAt + kAxis + "axis2 = [0, 1, 1]\n",
         "axis2 of a universal joint should be at right angles to axis"},
        {"wheel", kAt + kAxis + "axis2 = [0, 0, 1]\n", "at right angles"},
        {"look-at", "anchor_a = [1, 2, 0]\n" + kAxis,
         "the ends of a look-at joint are at the same point"},
        {"look-at", kAxis, "the world has no centre; give anchor_a"},
        {"distance", "anchor_a = [1, 2, 0]\nlimits = [0, 1]\nspring = { hz = 1 }\n",
         "the ends of a distance joint are 0 m apart"},
        {"distance", "anchor_a = [1, 4, 0]\nlimits = [-1, 1]\n", "should not be below 0"},
        {"six-dof", kAt, "leaves everything free"},
        {"six-dof", kAt + "x = 'lockd'\n", "did you mean 'locked'?"},
        {"six-dof", kAt + "x = 1\n", "x is 1; it should be \"free\", \"locked\" or a table"},
        {"six-dof", kAt + "x = { limits_deg = [0, 1] }\n",
         "unknown key 'limits_deg' in a coordinate; known are: limits, motor, spring"},
        {"six-dof", kAt + kAxis + "x = 'locked'\n",
         "has axis (its x) and axis2 (its y), or neither"},
        {"six-dof", kAt + kAxis + "axis2 = [0, 0, 1]\nx = 'locked'\n",
         "axis2 should not be parallel to axis"},
        {"gear", kAxis + "ratio = 0\n", "ratio is 0; it should be from 0.0001"},
        {"path", "points = [[0, 0, 0]]\n", "number of points is 1; a path should have 2 to 1000"},
        {"path", "closed = true\npoints = [[0, 0, 0], [1, 0, 0]]\n", "should have 3 to 1000"},
        {"path", "points = [[0, 0, 0], [1, 0, 0], [1, 0, 0]]\n",
         "point 2 of the path is at the same place as the one before"},
        {"path", "closed = true\npoints = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 0]]\n",
         "leave the last one out"},
        {"weld", kAt + "break_torque = -1\n", "break_torque is -1; it should be"},
    };
    for (const BadJoint& b : bad) {
        const auto lines = errorsOf("format = 1\n" + joint(b.type, b.keys));
        EXPECT_TRUE(tells(lines, "a.toml:", b.message)) << b.keys << listed(lines);
    }
}

}  // namespace
}  // namespace demos::test
