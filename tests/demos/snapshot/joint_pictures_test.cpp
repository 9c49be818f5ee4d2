// The drawing of joints, without and with --show joints.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "demos/snapshot/coil.h"
#include "demos/snapshot/snapshot.h"
#include "engine/base/trigonometry.h"
#include "tests/demos/reading.h"

namespace demos {
namespace {

using engine::JointType;

/// A ball of 0.2 m that hangs 2 m below the origin by a joint of this type, modified by `change`.
template <class Change>
Stage hanging(JointType type, Change change) {
    SceneDescription scene = test::read(
        "[[body]]\nname = 'ball'\nshape = { sphere = 0.2 }\nat = [0, -2, 0]\n"
        "[[joint]]\ntype = 'distance'\na = 'world'\nb = 'ball'\nanchor_a = [0, 0, 0]\n");
    scene.joints[0].def.type = type;
    scene.camera.from = {0, -1, 6};  // near: small coils are bars
    change(scene.joints[0].def);
    return Stage(scene);
}

render::Frame shownOf(const Stage& stage) {
    Overlays overlays;
    overlays.joints = true;
    return snapshot(stage, overlays, 0.0);
}

TEST(JointPicture, ASpringIsACoilFromEndToEnd) {
    const Stage stage =
        hanging(JointType::distance, [](engine::JointDef& def) { def.spring.hz = 2; });
    const std::vector<render::Rod> rods = snapshot(stage, {}, 0.0).rods;
    ASSERT_GT(rods.size(), 50u);
    EXPECT_EQ(rods.front().from, render::Vec3(0, 0, 0));
    EXPECT_LT((rods.back().to - render::Vec3(0, -2, 0)).norm(), 1e-6f);
    for (std::size_t i = 1; i < rods.size(); ++i) {
        EXPECT_EQ(rods[i].from, rods[i - 1].to) << i;
        EXPECT_EQ(rods[i].id, 1) << i;
    }
}

TEST(JointPicture, ASpringThatIsSmallInThePictureIsABar) {
    const auto rodsFrom = [](float away) {
        render::Frame frame;
        frame.camera.from = {0, 0, away};
        addCoil({0, 1, 0}, {0, -1, 0}, 1.0f, 7, frame);
        return frame.rods;
    };
    EXPECT_GT(rodsFrom(10).size(), 45u);
    const std::vector<render::Rod> far = rodsFrom(100);
    ASSERT_EQ(far.size(), 1u);
    EXPECT_EQ(far[0].from, render::Vec3(0, 1, 0));
    EXPECT_EQ(far[0].to, render::Vec3(0, -1, 0));
    EXPECT_EQ(far[0].id, 7);
    EXPECT_GT(far[0].radius, coilWire(1.0f));
}

TEST(JointPicture, ARigidRodIsOneRod) {
    const Stage stage = hanging(JointType::distance, [](engine::JointDef&) {});
    EXPECT_EQ(snapshot(stage, {}, 0.0).rods.size(), 1u);
}

TEST(JointPicture, ASpringForceIsACoilNumberedAfterTheJoints) {
    SceneDescription scene = test::read(
        "[[body]]\nname = 'ball'\nshape = { sphere = 0.2 }\nat = [0, -2, 0]\n"
        "[[force]]\ntype = 'spring'\na = 'world'\nb = 'ball'\nstiffness = 10\n");
    const std::vector<render::Rod> rods = snapshot(Stage(scene), {}, 0.0).rods;
    ASSERT_GT(rods.size(), 50u);
    for (const render::Rod& rod : rods) EXPECT_EQ(rod.id, 1);
}

TEST(JointPicture, ARailGoesFromLimitToLimit) {
    const Stage stage = hanging(JointType::slider, [](engine::JointDef& def) {
        def.anchorA = Vec3(0, -2, 0), def.axis = Vec3(0, 3, 0);
        def.free[0].limits = {-0.5, 1.5};
    });
    const std::vector<render::Rod> rods = snapshot(stage, {}, 0.0).rods;
    ASSERT_EQ(rods.size(), 1u);
    EXPECT_LT((rods[0].from - render::Vec3(0, -2.5, 0)).norm(), 1e-6f);
    EXPECT_LT((rods[0].to - render::Vec3(0, -0.5, 0)).norm(), 1e-6f);
}

TEST(JointPicture, ATrackGoesThroughThePointsOfItsPath) {
    const std::vector<Vec3> path{{0, -2, 0}, {1, -1, 0}, {2, -2, 0}, {3, 0, 1}};
    const Stage stage = hanging(JointType::path, [&](engine::JointDef& def) { def.path = path; });
    const std::vector<render::Rod> rods = snapshot(stage, {}, 0.0).rods;
    for (const Vec3& point : path)
        EXPECT_TRUE(std::any_of(rods.begin(), rods.end(), [&](const render::Rod& rod) {
            const render::Vec3 p = point.cast<float>();
            return (rod.from - p).norm() < 1e-5f || (rod.to - p).norm() < 1e-5f;
        })) << point.transpose();
}

bool isAmber(const render::Line& line) { return line.color.r > 0.9f && line.color.b < 0.1f; }

/// The largest angle of an amber line from straight down, in degrees.
double widestAmber(const render::Frame& frame) {
    double widest = 0.0;
    for (const render::Line& line : frame.lines)
        if (isAmber(line))
            widest = std::max(widest, std::abs(std::atan2(static_cast<double>(line.to.x()),
                                                          -static_cast<double>(line.to.y()))));
    return widest * 57.29577951308232;
}

TEST(JointPicture, AHingesLimitsAreAFanOfTheirAngle) {
    const auto fan = [](double degrees) {
        return shownOf(hanging(JointType::hinge, [&](engine::JointDef& def) {
            def.anchorB = Vec3(0, 2, 0);
            if (degrees > 0.0)
                def.free[0].limits = {-engine::radians(degrees), engine::radians(degrees)};
        }));
    };
    EXPECT_NEAR(widestAmber(fan(40.0)), 40.0, 1e-3);
    EXPECT_NEAR(widestAmber(fan(75.0)), 75.0, 1e-3);
    EXPECT_EQ(widestAmber(fan(0.0)), 0.0);
}

bool isBlue(const render::Line& line) { return line.color.b > 0.7f && line.color.r < 0.2f; }

template <class Kind>
std::vector<render::Line> linesOf(const Stage& stage, Kind kind) {
    std::vector<render::Line> found;
    for (const render::Line& line : shownOf(stage).lines)
        if (kind(line)) found.push_back(line);
    return found;
}

/// Whether one of the lines ends at this point; m.
bool anyEndsAt(const std::vector<render::Line>& lines, const render::Vec3& at) {
    return std::any_of(lines.begin(), lines.end(), [&](const render::Line& line) {
        return (line.to - at).norm() < 1e-4f;  // float, and an integrated rotation
    });
}

/// Sizes of the marks around the ball: 1.2 times its radius, and 0.8 of that for a fan.
constexpr float kMarkSize = 1.2f * 0.2f, kFan = 0.8f * kMarkSize;
const render::Vec3 kBallAt(0, -2, 0);

TEST(JointPicture, AFanStandsStillWhileTheHandOfACentredBodyTurns) {
    // Without gravity, about an axis through its centre: 1 rad/s, so 0.5 rad after half a second.
    Stage stage = hanging(JointType::hinge, [](engine::JointDef& def) {
        def.anchorA = Vec3(0, -2, 0);
        def.free[0].limits = {-1.0, 1.0};
        def.free[0].motor = {1.0, engine::kUnlimited};
    });
    const auto before = linesOf(stage, isAmber);
    const auto handBefore = linesOf(stage, isBlue);
    for (int i = 0; i < 120; ++i) stage.world.step(1.0 / 240.0);
    const auto after = linesOf(stage, isAmber);
    const auto hand = linesOf(stage, isBlue);
    ASSERT_EQ(before.size(), after.size());
    ASSERT_GT(before.size(), 2u);
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_LT((before[i].to - after[i].to).norm(), 1e-4f) << i;
    ASSERT_EQ(handBefore.size(), 1u);
    ASSERT_EQ(hand.size(), 1u);
    const double angle = stage.world.joint(stage.joints[0]).position;
    EXPECT_GT(angle, 0.3);
    const render::Vec3 from = handBefore[0].to - kBallAt, to = hand[0].to - kBallAt;
    EXPECT_NEAR(std::atan2(from.cross(to).z(), from.dot(to)), angle, 1e-4);  // same direction
}

TEST(JointPicture, AFanGoesRoundWithA) {
    SceneDescription scene = test::read(
        "[world]\ngravity = [0, 0, 0]\n"
        "[[body]]\nname = 'arm'\nshape = { sphere = 0.2 }\nat = [1, 0, 0]\nspin = [0, 0, 2]\n"
        "[[body]]\nname = 'ball'\nshape = { sphere = 0.2 }\nspin = [0, 0, 2]\n"
        "[[joint]]\ntype = 'axis'\na = 'arm'\nb = 'ball'\naxis = [0, 0, 1]\n"
        "limits_deg = [-30, 60]\n");
    Stage stage(scene);
    const auto before = linesOf(stage, isAmber);
    for (int i = 0; i < 10; ++i) stage.world.step(0.01);  // 0.2 rad
    const auto after = linesOf(stage, isAmber);
    ASSERT_EQ(before.size(), after.size());
    const render::Vec3 from = before.back().to, to = after.back().to;
    EXPECT_NEAR(std::atan2(from.cross(to).z(), from.dot(to)), 0.2, 1e-3);
}

TEST(JointPicture, ASwingIsAConeAboutTheAxis) {
    const double swing = engine::radians(35.0);
    const Stage stage = hanging(JointType::ball, [&](engine::JointDef& def) {
        def.anchorB = Vec3(0, 2, 0), def.axis = Vec3(0, -1, 0);
        def.free[1].limits.high = swing;
    });
    const auto cone = linesOf(stage, isAmber);
    ASSERT_GT(cone.size(), 4u);
    int spokes = 0;
    for (const render::Line& line : cone) {
        const float off = std::acos(-line.to.normalized().y());
        EXPECT_NEAR(off, swing, 1e-5);
        EXPECT_NEAR(line.to.norm(), kMarkSize, 1e-6);
        spokes += line.from.norm() < 1e-6f ? 1 : 0;
    }
    EXPECT_EQ(spokes, 4);
    EXPECT_TRUE(anyEndsAt(linesOf(stage, isBlue), {0, -kMarkSize, 0}));  // b's axis, at rest
}

TEST(JointPicture, NoConeIsDrawnWhereNoSwingIsTooMuch) {
    for (const JointType type : {JointType::ball, JointType::constantVelocity}) {
        const Stage stage = hanging(type, [](engine::JointDef& def) {
            def.anchorB = Vec3(0, 2, 0), def.free[1].limits.high = engine::kPi;
        });
        EXPECT_TRUE(linesOf(stage, isAmber).empty());
    }
}

TEST(JointPicture, ATwistIsAFanAboutTheAxis) {
    const Stage stage = hanging(JointType::ball, [](engine::JointDef& def) {
        def.anchorB = Vec3(0, 2, 0), def.axis = Vec3(0, -1, 0);
        def.free[0].limits = {-engine::radians(20.0), engine::radians(50.0)};
    });
    const auto fan = linesOf(stage, isAmber);
    ASSERT_GT(fan.size(), 2u);
    for (const render::Line& line : fan) EXPECT_NEAR(line.to.y(), 0.0, 1e-6);  // across the axis
    const render::Vec3 low = fan[fan.size() - 2].to, high = fan.back().to;
    EXPECT_NEAR(std::acos(low.normalized().dot(high.normalized())), engine::radians(70.0), 1e-4);
}

TEST(JointPicture, AUniversalJointHasAFanForEachAngle) {
    const double first = engine::radians(30.0), second = engine::radians(60.0);
    const Stage stage = hanging(JointType::universal, [&](engine::JointDef& def) {
        def.anchorA = Vec3(0, -2, 0), def.axis = Vec3(1, 0, 0), def.axis2 = Vec3(0, 0, 1);
        def.free[0].limits = {0.0, first}, def.free[1].limits = {0.0, second};
    });
    const auto fans = linesOf(stage, isAmber);
    const auto at = [](double x, double y, double z) {
        return render::Vec3(kBallAt + kFan * Vec3(x, y, z).cast<float>());
    };
    // axis2 turns about x; b's first pin turns about z. Right-handed.
    EXPECT_TRUE(anyEndsAt(fans, at(0, -std::sin(first), std::cos(first))));
    EXPECT_TRUE(anyEndsAt(fans, at(std::cos(second), std::sin(second), 0)));
    EXPECT_FALSE(anyEndsAt(fans, at(std::cos(second), -std::sin(second), 0)));
}

TEST(JointPicture, TheHandsOfAUniversalJointGoWithTheBody) {
    // Turned by 0.4 about z from its initial pose: that is the second angle, and b's x axis has
    // turned by it.
    Stage stage = hanging(JointType::universal, [](engine::JointDef& def) {
        def.anchorA = Vec3(0, -2, 0), def.axis = Vec3(1, 0, 0), def.axis2 = Vec3(0, 0, 1);
        def.free[1].limits = {-1.0, 1.0};
    });
    const engine::BodyId ball = stage.bodies[0];
    stage.world.setPose(ball, {Vec3(0, -2, 0), engine::turnAbout(Vec3::UnitZ(), 0.4)});
    const auto hands = linesOf(stage, isBlue);
    ASSERT_EQ(hands.size(), 1u);
    const render::Vec3 tip = Vec3(std::cos(0.4), std::sin(0.4), 0.0).cast<float>();
    EXPECT_LT((hands[0].to - (kBallAt + kFan * tip)).norm(), 1e-5f);
}

TEST(JointPicture, ASixDofShowsItsFrameAndWhatIsLimited) {
    const Stage stage = hanging(JointType::sixDof, [](engine::JointDef& def) {
        def.anchorA = Vec3(0, -2, 0), def.axis = Vec3(0, 1, 0), def.axis2 = Vec3(0, 0, 1);
        for (engine::Freedom& f : def.free) f.locked = true;
        def.free[1] = {}, def.free[1].limits = {-0.5, 1.5};  // its y, the world's z
        def.free[5] = {}, def.free[5].limits = {0.0, 0.5};   // about its z, the world's x
    });
    const auto any = linesOf(stage, [](const render::Line&) { return true; });
    for (const render::Vec3& way :
         {render::Vec3(0, 1, 0), render::Vec3(0, 0, 1), render::Vec3(1, 0, 0)})
        EXPECT_TRUE(anyEndsAt(any, kBallAt + kMarkSize * way)) << way.transpose();
    const auto amber = linesOf(stage, isAmber);
    EXPECT_TRUE(anyEndsAt(amber, kBallAt + render::Vec3(0, 0, 1.5f)));
    EXPECT_LT((amber.front().from - (kBallAt + render::Vec3(0, 0, -0.5f))).norm(), 1e-6f);
    const render::Vec3 tip = Vec3(0.0, std::cos(0.5), std::sin(0.5)).cast<float>();
    EXPECT_TRUE(anyEndsAt(amber, kBallAt + kFan * tip));
}

TEST(JointPicture, AWheelShowsItsSuspension) {
    const auto wheel = [](double hz) {
        return hanging(JointType::wheel, [&](engine::JointDef& def) {
            def.anchorA = Vec3(0, -2, 0), def.axis = Vec3(0, 1, 0), def.axis2 = Vec3(0, 0, 1);
            def.free[0].limits = {-0.25, 0.5};
            def.free[0].spring.hz = hz;
        });
    };
    EXPECT_TRUE(anyEndsAt(linesOf(wheel(0.0), isAmber), {0, -1.5f, 0}));
    EXPECT_LT((linesOf(wheel(0.0), isAmber).front().from - render::Vec3(0, -2.25f, 0)).norm(),
              1e-6f);
    // 9 turns of five to ten lines are the coil.
    EXPECT_GT(shownOf(wheel(2.0)).lines.size(), shownOf(wheel(0.0)).lines.size() + 45);
    EXPECT_TRUE(snapshot(wheel(2.0), {}, 0.0).lines.empty());
}

TEST(JointPicture, AnAnchorOfTheWorldIsSeenThroughTheOtherBody) {
    const Stage stage =
        hanging(JointType::hinge, [](engine::JointDef& def) { def.anchorA = Vec3(0, -2, 0); });
    const std::vector<render::Marker> dots = shownOf(stage).markers;
    ASSERT_EQ(dots.size(), 2u);
    for (const render::Marker& dot : dots) EXPECT_GE(dot.reach, 2.0f * 0.2f);
}

TEST(JointPicture, MarksAreDrawnOnlyWhenAskedFor) {
    for (const JointType type : {JointType::hinge, JointType::lookAt, JointType::axis}) {
        const Stage stage =
            hanging(type, [](engine::JointDef& def) { def.anchorB = Vec3(0, 2, 0); });
        EXPECT_TRUE(snapshot(stage, {}, 0.0).lines.empty());
        EXPECT_FALSE(shownOf(stage).lines.empty());
    }
}

}  // namespace
}  // namespace demos
