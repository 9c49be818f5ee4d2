// The camera moves through its keys: closed forms at the ends, half way and at cuts.

#include "demos/snapshot/camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "demos/film/shutter.h"
#include "demos/snapshot/player.h"
#include "tests/demos/reading.h"

namespace demos::test {
namespace {

/// From (0, 2, 10) at 0 s to (8, 2, 10) from 1 s to 3 s with this ease, and on to a cut at 4 s.
CameraDescription travel(Ease ease) {
    CameraDescription camera;
    camera.from = {0, 2, 10};
    camera.fovDegrees = 30.0;
    camera.keys = {{1.0, {0, 2, 10}, {0, 2, 0}, 30.0, Ease::smooth},
                   {3.0, {8, 2, 10}, {0, 4, 0}, 50.0, ease},
                   {4.0, {0, 9, 9}, {1, 1, 1}, 20.0, Ease::cut}};
    return camera;
}

double x(Ease ease, double time) { return viewAt(travel(ease), time).from.x(); }

TEST(Camera, StaysWithoutKeys) {
    const CameraView view = viewAt(CameraDescription(), 3.0);
    EXPECT_EQ(view.from, CameraDescription().from);
    EXPECT_EQ(view.lookAt, CameraDescription().lookAt);
    EXPECT_EQ(view.fovDegrees, 35.0);
}

TEST(Camera, IsAtEveryKeyAtItsTime) {
    for (const Ease ease : {Ease::smooth, Ease::linear, Ease::in, Ease::out, Ease::cut}) {
        EXPECT_EQ(x(ease, 1.0), 0.0);
        EXPECT_EQ(x(ease, 3.0), 8.0);
    }
}

TEST(Camera, EasesAsItsFormulasSay) {  // at s = 1/4 and 1/2 of the way of 8 m
    EXPECT_NEAR(x(Ease::smooth, 1.5), 8.0 * (3.0 / 16 - 2.0 / 64), 1e-12);
    EXPECT_NEAR(x(Ease::smooth, 2.0), 4.0, 1e-12);
    EXPECT_NEAR(x(Ease::linear, 1.5), 2.0, 1e-12);
    EXPECT_NEAR(x(Ease::in, 1.5), 0.5, 1e-12);
    EXPECT_NEAR(x(Ease::out, 1.5), 3.5, 1e-12);
    EXPECT_EQ(x(Ease::cut, 2.999), 0.0);
}

TEST(Camera, MovesWhatItLooksAtAndItsAngleAlike) {
    const CameraView view = viewAt(travel(Ease::smooth), 2.0);
    EXPECT_NEAR(view.lookAt.y(), 3.0, 1e-12);
    EXPECT_NEAR(view.fovDegrees, 40.0, 1e-12);
}

TEST(Camera, ComesFromItsOwnViewAtTheStart) {
    CameraDescription camera = travel(Ease::linear);
    camera.from = {-4, 2, 10};
    EXPECT_EQ(viewAt(camera, 0.0).from.x(), -4.0);
    EXPECT_NEAR(viewAt(camera, 0.5).from.x(), -2.0, 1e-12);  // smooth: half way
}

TEST(Camera, StaysAtTheLastKey) {
    EXPECT_EQ(viewAt(travel(Ease::linear), 100.0).from, Vec3(0, 9, 9));
}

TEST(Camera, CutsAtTheTimeWhateverItsLastBit) {
    const CameraDescription camera = travel(Ease::linear);
    EXPECT_EQ(viewAt(camera, 4.0 - 1e-3).from, Vec3(8, 2, 10));
    EXPECT_EQ(viewAt(camera, std::nextafter(4.0, 0.0)).from, Vec3(0, 9, 9));
    EXPECT_EQ(shotAt(camera, 3.9), 0);
    EXPECT_EQ(shotAt(camera, std::nextafter(4.0, 0.0)), 1);
}

TEST(Camera, AKeyAtTheStartIsItsBeginning) {
    CameraDescription camera;
    camera.keys = {{0.0, {1, 2, 3}, {0, 0, 0}, 40.0, Ease::smooth}};
    EXPECT_EQ(viewAt(camera, 0.0).from, Vec3(1, 2, 3));
}

const std::string kFlight =
    "[world]\ngravity = [0, 0, 0]\n"
    "[[body]]\nname = 'ball'\nshape = { sphere = 0.5 }\nat = [0, 2, 0]\nvelocity = [3, 0, 0]\n"
    "[camera]\nfrom = [0, 2, 10]\nlook_at = [0, 2, 0]\n";

render::Camera afterASecond(const std::string& camera) {
    Player player(read(kFlight + camera), {});
    player.step(60);
    return player.frame(1.0).camera;
}

TEST(Camera, FollowsGluedUnlessItHasALag) {
    EXPECT_NEAR(afterASecond("follow = 'ball'\n").from.x(), 3.0f, 1e-5f);
    EXPECT_NEAR(afterASecond("follow = 'ball'\nfollow_lag = 0\n").from.x(), 3.0f, 1e-5f);
}

// Behind by e_n = q (e_{n-1} + v dt), q = exp(-dt / T): v dt q (1 - q^n) / (1 - q)
TEST(Camera, ComesAfterByItsLag) {
    const double dt = 1.0 / 60, q = std::exp(-dt / 0.5);
    const double behind = 3.0 * dt * q * (1.0 - std::pow(q, 60)) / (1.0 - q);
    const render::Camera camera = afterASecond("follow = 'ball'\nfollow_lag = 0.5\n");
    EXPECT_GT(behind, 1.0);
    EXPECT_NEAR(camera.from.x(), 3.0 - behind, 1e-5);
    EXPECT_NEAR(camera.lookAt.x(), 3.0 - behind, 1e-5);
}

TEST(Camera, FollowAndOrbitComeOnTopOfTheKeys) {
    const render::Camera camera = afterASecond(
        "follow = 'ball'\norbit_deg_per_s = 90\nkeys = [{ at = 1, from = [0, 7, 20] }]\n");
    EXPECT_NEAR(camera.from.x(), 3.0f + 20.0f, 1e-4f);  // a quarter round, and 3 m along
    EXPECT_NEAR(camera.from.y(), 7.0f, 1e-5f);
    EXPECT_NEAR(camera.from.z(), 0.0f, 1e-4f);
}

TEST(Camera, FocusesOnABodyAlongTheViewAxis) {
    const render::Camera camera = afterASecond("aperture = 0.2\nfocus = 'ball'\n");
    EXPECT_FLOAT_EQ(camera.aperture, 0.2f);
    EXPECT_NEAR(camera.focus, 10.0f, 1e-5f);  // not the 10.44 m of the straight line
    EXPECT_FLOAT_EQ(afterASecond("focus = 4.5\n").focus, 4.5f);
    EXPECT_FLOAT_EQ(afterASecond("").focus, 10.0f);
}

TEST(Camera, FocusesWhereItLooksWhenTheBodyIsBehindIt) {
    const render::Camera camera = afterASecond(
        "focus = 'ball'\nkeys = [{ at = 1, look_at = "
        "[0, 2, 30], ease = 'cut' }]\n");
    EXPECT_FLOAT_EQ(camera.focus, 20.0f);
}

TEST(Camera, BlurMixesItsLens) {
    render::Frame a, b;
    a.camera.fovDegrees = 30.0f;
    b.camera.fovDegrees = 40.0f;
    a.camera.focus = 2.0f;
    b.camera.focus = 4.0f;
    EXPECT_FLOAT_EQ(between(a, b, 0.25f).camera.fovDegrees, 32.5f);
    EXPECT_FLOAT_EQ(between(a, b, 0.25f).camera.focus, 2.5f);
}

TEST(CameraKeys, KeepWhatTheyDoNotSay) {
    const CameraDescription camera =
        read(
            kBall +
            "[camera]\nfrom = [0, 2, 10]\nfov_deg = 30\nkeys = [{ at = 1, look_at = [1, 1, 1] },"
            "{ at = 2, from = [5, 2, 9], ease = 'out' }, { at = 5, fov_deg = 20, ease = 'cut' }]\n")
            .camera;
    ASSERT_EQ(camera.keys.size(), 3u);
    EXPECT_EQ(camera.keys[0].from, Vec3(0, 2, 10));
    EXPECT_EQ(camera.keys[0].ease, Ease::smooth);
    EXPECT_EQ(camera.keys[1].lookAt, Vec3(1, 1, 1));
    EXPECT_EQ(camera.keys[1].fovDegrees, 30.0);
    EXPECT_EQ(camera.keys[1].ease, Ease::out);
    EXPECT_EQ(camera.keys[2].from, Vec3(5, 2, 9));
    EXPECT_EQ(camera.keys[2].ease, Ease::cut);
}

TEST(CameraKeys, CanBeTablesOfTheirOwn) {
    const std::string text = "[[camera.keys]]\nat = 1\n[[camera.keys]]\nat = 2\nease = 'in'\n";
    const CameraDescription camera = read(kBall + text).camera;
    ASSERT_EQ(camera.keys.size(), 2u);
    EXPECT_EQ(camera.keys[1].ease, Ease::in);
}

TEST(CameraKeys, TellSeveralErrorsInOneRun) {
    const std::vector<std::string> lines = errorsOf(
        "format = 1\n" + kBall +
        "[camera]\nkeys = [\n{ at = 1, ease = 'smoth' },\n{ at = 9 },\n{ fov = 3, at = 2 }]\n");
    ASSERT_EQ(lines.size(), 3u) << listed(lines);
    EXPECT_TRUE(tells(lines, "a.toml:8:18: ", "did you mean 'smooth'?")) << listed(lines);
    EXPECT_TRUE(tells(lines, "a.toml:9:8: ", "from 0 to 5 s")) << listed(lines);
    EXPECT_TRUE(tells(lines, "a.toml:10:3: ", "did you mean 'fov_deg'?")) << listed(lines);
}

TEST(CameraKeys, MayPassOverheadByACut) {
    const std::string camera = "[camera]\nfrom = [0, 9, 5]\nlook_at = [0, 0, 0]\n";
    EXPECT_TRUE(errorsOf("format = 1\n" + kBall + camera +
                         "keys = [{ at = 1, from = [0, 9, -5], ease = 'cut' }]\n")
                    .empty());
}

/// On the axis of a camera that looks from (0, 2, 10) to (0, 2, 0), in a film of 8 s.
Vec3 movedFrom(CameraMove move, double time) {
    CameraDescription camera;
    camera.from = {0, 2, 10}, camera.lookAt = {0, 2, 0};
    camera.move = move;
    return movedAt(camera, time, 8.0).from;
}

TEST(CameraMove, PushGoesAnEighthInAndStops) {
    EXPECT_NEAR(movedFrom(CameraMove::push, 0.0).z(), 10.0, 1e-12);
    EXPECT_NEAR(movedFrom(CameraMove::push, 4.0).z(), 9.4, 1e-12);
    EXPECT_NEAR(movedFrom(CameraMove::push, 8.0).z(), 8.8, 1e-12);
    EXPECT_NEAR(movedFrom(CameraMove::push, 9.0).z(), 8.8, 1e-12);
    EXPECT_NEAR(movedFrom(CameraMove::push, 0.08).z(), 10.0, 1e-3);  // starts at rest
}

TEST(CameraMove, OrbitIsAtFromInTheMiddleOfTheFilm) {
    const double half = 12.5 * 3.14159265358979 / 180.0;
    EXPECT_NEAR(movedFrom(CameraMove::orbit, 0.0).x(), -10.0 * std::sin(half), 1e-9);
    EXPECT_NEAR(movedFrom(CameraMove::orbit, 4.0).x(), 0.0, 1e-12);
    EXPECT_NEAR(movedFrom(CameraMove::orbit, 8.0).x(), 10.0 * std::sin(half), 1e-9);
}

TEST(CameraMove, FollowKeepsTheMiddleOfTheMovingBodiesInPlace) {
    const std::string bodies =
        "[world]\ngravity = [0, 0, 0]\n"
        "[[body]]\nname = 'a'\nshape = { sphere = 0.1 }\nat = [0, 0, 0]\nvelocity = [2, 0, 0]\n"
        "[[body]]\nname = 'b'\nshape = { sphere = 0.1 }\nat = [0, 1, 0]\nvelocity = [2, 0, 0]\n"
        "[[body]]\nname = 'c'\nshape = { sphere = 0.1 }\nat = [0, 2, 0]\nvelocity = [2, 50, 0]\n"
        "[camera]\nfrom = [0, 1, 10]\nlook_at = [0, 1, 0]\nmove = 'follow'\n";
    Player sharp(read(bodies + "follow_lag = 0\n"), {}), lagging(read(bodies), {});
    sharp.step(60), lagging.step(60);
    EXPECT_NEAR(sharp.frame(1.0).camera.lookAt.x(), 2.0f, 1e-5f);
    EXPECT_NEAR(sharp.frame(1.0).camera.lookAt.y(), 1.0f, 1e-5f);  // c has left, the others not
    const double behind = 1.0 - std::exp(-2.0);  // v T (1 - e^(-t / T)) in m, T = 0.5 s
    EXPECT_NEAR(lagging.frame(1.0).camera.lookAt.x(), 2.0 - behind, 0.02);
}

TEST(CameraMove, IsRefusedBesideOtherMotionsOfTheCamera) {
    for (const std::string other :
         {"keys = [{ at = 1 }]", "orbit_deg_per_s = 9", "follow = 'ball'"}) {
        const std::vector<std::string> lines =
            errorsOf("format = 1\n" + kBall + "[camera]\nmove = 'push'\n" + other + "\n");
        EXPECT_TRUE(tells(lines, "a.toml:7:1: ", "both move the camera; leave one of them out"))
            << listed(lines);
    }
    EXPECT_TRUE(tells(errorsOf("format = 1\n" + kBall + "[camera]\nmove = 'pus'\n"), "a.toml:7:8: ",
                      "did you mean 'push'?"));
}

}  // namespace
}  // namespace demos::test
