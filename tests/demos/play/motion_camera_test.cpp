// A scene without a camera is framed by its motion: the box of all of it fills 70 % of the picture.
#include "demos/play/motion_camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/camera.h"
#include "tests/demos/reading.h"

namespace demos::test {
namespace {

SceneDescription framed(SceneDescription scene) {
    SceneDescription* const one = &scene;
    fitToMotion({&one, 1});
    return scene;
}

/// The largest distance of the ball from the picture's middle during the run, as a share of half
/// the picture's width or height, in 16:9.
double filled(const SceneDescription& scene, std::size_t body) {
    Stage stage(scene);
    const CameraDescription& camera = scene.camera;
    const render::View view = render::makeView(
        {camera.from.cast<float>(), camera.lookAt.cast<float>()}, 16.0f / 9.0f);
    double most = 0.0;
    for (int step = 0; step <= std::lround(scene.seconds * scene.hz); ++step) {
        const Vec3 place = stage.world.pose(stage.bodies[body]).position;
        const render::Projected at = render::project(view, place.cast<float>(), 1600, 900);
        most = std::max({most, std::abs(static_cast<double>(at.x) - 800.0) / 800.0,
                         std::abs(static_cast<double>(at.y) - 450.0) / 450.0});
        stage.step();
    }
    return most;
}

std::string ball(const std::string& name, double radius, const std::string& at,
                 const std::string& velocity = "[0, 0, 0]") {
    return "[[body]]\nname = '" + name + "'\nshape = { sphere = " + std::to_string(radius) +
           " }\nat = " + at + "\nvelocity = " + velocity + "\n";
}

TEST(MotionCamera, TheWholePathFillsThePicture) {
    for (const std::string velocity : {"[0, 0, 0]", "[3, 4, 0]", "[0, 2, 4]", "[-20, 9, 3]"}) {
        const SceneDescription scene =
            framed(read("seconds = 2\n" + kFloor + ball("a", 0.05, "[0, 1, 0]", velocity)));
        EXPECT_LE(filled(scene, 1), 0.75) << velocity;
        EXPECT_GE(filled(scene, 1), 0.4) << velocity;
    }
}

TEST(MotionCamera, IsTheSameFromARunThatIsMadeAnyway) {
    for (const std::string move : {"", "[camera]\nfov_deg = 50\nmove = 'follow'\n"}) {
        const SceneDescription scene =
            read("seconds = 2\n" + move + kFloor + ball("a", 0.05, "[0, 1, 0]", "[3, 4, 0]"));
        Stage stage(scene);
        MotionSampler sampler(stage.scene);
        for (long step = 0; step <= std::lround(scene.seconds * scene.hz); ++step) {
            sampler.look(stage, step);
            stage.step();
        }
        const CameraDescription camera = sampler.camera(), fitted = framed(scene).camera;
        EXPECT_EQ(camera.from, fitted.from) << move;
        EXPECT_EQ(camera.lookAt, fitted.lookAt) << move;
        EXPECT_FALSE(camera.fitsMotion);
    }
}

TEST(MotionCamera, ASmallThingAtRestIsLarge) {
    const SceneDescription scene = framed(read(kFloor + ball("a", 0.05, "[7, 0.05, 3]")));
    EXPECT_NEAR((scene.camera.lookAt - Vec3(7, 0.05, 3)).norm(), 0.0, 1e-3);
    EXPECT_LT((scene.camera.from - scene.camera.lookAt).norm(), 0.4);
}

TEST(MotionCamera, BodiesThatLeaveForEverDoNotCount) {
    std::string heap = "seconds = 4\n" + kFloor;
    for (int i = 0; i < 9; ++i)
        heap += ball("b" + std::to_string(i), 0.2, "[" + std::to_string(i % 3) + ", 0.2, " +
                                                       std::to_string(i / 3) + "]");
    const CameraDescription alone = framed(read(heap)).camera;
    const CameraDescription camera =
        framed(read(heap + ball("lost", 0.2, "[1, 1, 1]", "[90, 90, 0]"))).camera;
    const double near = (alone.from - alone.lookAt).norm();
    EXPECT_LT((camera.from - camera.lookAt).norm(), 2.5 * near);
}

TEST(MotionCamera, OfTwoBodiesFarApartBothAreSeen) {
    const SceneDescription scene = framed(
        read("seconds = 1\n" + kFloor + ball("a", 0.2, "[-9, 0.2, 0]") + ball("b", 0.2, "[9, 0.2, 0]")));
    for (const std::size_t body : {1u, 2u}) EXPECT_LE(filled(scene, body), 0.75);
}

TEST(MotionCamera, TheOnlyBodyThatMovesIsSeen) {
    std::string scene = "seconds = 1\n" + kFloor + ball("comes", 0.2, "[-9, 0.2, 0]", "[8, 0, 0]");
    for (int i = 0; i < 5; ++i)
        scene += ball("b" + std::to_string(i), 0.2, "[" + std::to_string(0.5 * i) + ", 0.2, 0]");
    EXPECT_LE(filled(framed(read(scene)), 1), 0.75);
}

TEST(MotionCamera, FixedSceneryCountsOnlyIfItIsNotLarge) {
    const std::string bob = ball("bob", 0.1, "[0, 1, 0]");
    const auto box = [](const char* name, const char* size) {
        return std::string("[[body]]\nname = '") + name + "'\nshape = { box = " + size +
               " }\nat = [0, 0.5, 0]\nfixed = true\n";
    };
    const auto away = [](const SceneDescription& scene) {
        return (scene.camera.from - scene.camera.lookAt).norm();
    };
    const double table = away(framed(read(bob + box("table", "[0.3, 0.3, 0.3]"))));
    EXPECT_NEAR(away(framed(read(bob + box("hall", "[50, 0.3, 50]")))), table, 0.5 * table);
}

TEST(MotionCamera, IsTheSameForAllVariants) {
    SceneDescription slow = read(kFloor + ball("a", 0.1, "[0, 1, 0]", "[1, 0, 0]"));
    SceneDescription fast = read(kFloor + ball("a", 0.1, "[0, 1, 0]", "[9, 0, 0]"));
    SceneDescription* const both[] = {&slow, &fast};
    fitToMotion(both);
    EXPECT_EQ(slow.camera.from, fast.camera.from);
    EXPECT_EQ(slow.camera.lookAt, fast.camera.lookAt);
    EXPECT_LE(filled(slow, 1), 0.75);
    EXPECT_LE(filled(fast, 1), 0.85);  // one of 50 samples is cut, of both together
}

TEST(MotionCamera, AGivenCameraStays) {
    for (const std::string given : {"from = [1, 2, 3]", "look_at = [1, 2, 3]", "follow = 'ball'"}) {
        const SceneDescription scene = read(kBall + "[camera]\n" + given + "\n");
        EXPECT_EQ(framed(scene).camera.from, scene.camera.from) << given;
    }
    const SceneDescription lens = read(kBall + "[camera]\nfov_deg = 20\nmove = 'orbit'\n");
    EXPECT_NE(framed(lens).camera.from, lens.camera.from);
    EXPECT_EQ(framed(lens).camera.fovDegrees, 20.0);
}

TEST(MotionCamera, SeesAnEmptySceneAsBefore) {
    const SceneDescription empty = read(kFloor);
    EXPECT_EQ(framed(empty).camera.from, empty.camera.from);
}

}  // namespace
}  // namespace demos::test
