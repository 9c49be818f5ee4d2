// What is drawn of joints, and with --show joints.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "demos/snapshot.h"
#include "engine/base/trigonometry.h"
#include "tests/demos/reading.h"

namespace demos {
namespace {

using engine::JointType;

/// A ball of 0.2 m that hangs 2 m below the origin by a joint of this type, which `change` makes its own.
template <class Change>
Stage hanging(JointType type, Change change) {
    SceneDescription scene = test::read(
        "[[body]]\nname = 'ball'\nshape = { sphere = 0.2 }\nat = [0, -2, 0]\n"
        "[[joint]]\ntype = 'distance'\na = 'world'\nb = 'ball'\nanchor_a = [0, 0, 0]\n");
    scene.joints[0].def.type = type;
    change(scene.joints[0].def);
    return Stage(scene);
}

render::Frame shownOf(const Stage& stage) {
    Overlays overlays;
    overlays.joints = true;
    return snapshot(stage, overlays, 0.0);
}

TEST(JointPicture, ASpringIsACoilFromEndToEnd) {
    const Stage stage = hanging(JointType::distance, [](engine::JointDef& def) { def.spring.hz = 2; });
    const std::vector<render::Rod> rods = snapshot(stage, {}, 0.0).rods;
    ASSERT_GT(rods.size(), 50u);
    EXPECT_EQ(rods.front().from, render::Vec3(0, 0, 0));
    EXPECT_LT((rods.back().to - render::Vec3(0, -2, 0)).norm(), 1e-6f);
    for (std::size_t i = 1; i < rods.size(); ++i) {
        EXPECT_EQ(rods[i].from, rods[i - 1].to) << i;
        EXPECT_EQ(rods[i].id, 1) << i;
    }
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
    const Stage stage =
        hanging(JointType::path, [&](engine::JointDef& def) { def.path = path; });
    const std::vector<render::Rod> rods = snapshot(stage, {}, 0.0).rods;
    for (const Vec3& point : path)
        EXPECT_TRUE(std::any_of(rods.begin(), rods.end(), [&](const render::Rod& rod) {
            const render::Vec3 p = point.cast<float>();
            return (rod.from - p).norm() < 1e-5f || (rod.to - p).norm() < 1e-5f;
        })) << point.transpose();
}

/// The farthest any line in amber goes round from straight down, in degrees.
double widestAmber(const render::Frame& frame) {
    double widest = 0.0;
    for (const render::Line& line : frame.lines)
        if (line.color.r > 0.9f && line.color.b < 0.1f)
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
