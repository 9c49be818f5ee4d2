#include "demos/film/framing.h"

#include <gtest/gtest.h>

#include "demos/snapshot/player.h"
#include "render/camera.h"
#include "render/corners.h"
#include "tests/demos/reading.h"

namespace demos {
namespace {

const std::string kCamera = "[camera]\nfrom = [0, 2, 10]\nlook_at = [0, 2, 0]\nfov_deg = 30\n";

render::Frame frameOf(const Overlays& overlays, int steps = 0) {
    Player player(test::read(test::kFloor + test::kBall + kCamera), overlays);
    player.step(steps);
    return player.frame(0.01 * steps);
}

/// The share of the picture's width, from the left.
float placeOf(const render::Frame& frame, const render::Vec3& point, int width, int height) {
    const render::View view = render::makeView(
        frame.camera, static_cast<float>(width) / static_cast<float>(height));
    return render::project(view, point, width, height).x / static_cast<float>(width);
}

render::Frame fitted(render::Frame frame, int width, int height) {
    fitCamera(width, height, frame);
    return frame;
}

const render::Vec3 kMiddle(0, 2, 0), kRight(1.5f, 2, 0);

TEST(Framing, WidePicturesStayAsTheyAre) {
    const render::Frame frame = frameOf({.stats = true});
    for (const auto& [w, h] : {std::pair(1280, 720), {1920, 1080}, {640, 480}, {3840, 2160}}) {
        const render::Frame after = fitted(frameOf({}), w, h);
        EXPECT_EQ(after.camera.fovDegrees, frame.camera.fovDegrees);
        EXPECT_EQ(after.camera.from, frame.camera.from);
    }
    EXPECT_EQ(fitted(frame, 1280, 720).camera.from, frame.camera.from);  // room enough beside it
}

TEST(Framing, NarrowPicturesSeeAsMuchAtTheSidesAsThoseOf4To3) {
    const render::Frame frame = frameOf({});
    const float wide = placeOf(fitted(frame, 800, 600), kRight, 800, 600);
    for (const auto& [w, h] : {std::pair(600, 600), {720, 1280}, {270, 480}})
        EXPECT_NEAR(placeOf(fitted(frame, w, h), kRight, w, h), wide, 1e-4f) << w << "x" << h;
    EXPECT_GT(placeOf(frame, kRight, 270, 480), 0.9f);  // without: almost outside
}

TEST(Framing, TheSubjectIsBesideTheStatisticsInSmallPictures) {
    const render::Frame frame = frameOf({.stats = true});
    for (const auto& [w, h] : {std::pair(480, 270), {640, 360}, {854, 480}, {400, 300}}) {
        const render::Frame after = fitted(frame, w, h);
        const render::CornerLayout layout = render::layoutCorners(after, w, h);
        ASSERT_FALSE(layout.plates.empty()) << w;
        const render::Box& plate = layout.plates.front().box;
        const float subject = placeOf(after, kMiddle, w, h);
        EXPECT_LE((subject + 0.29f) * static_cast<float>(w), plate.x) << w;
        EXPECT_GT(subject, 0.25f) << w;  // and not out of the picture on the other side
    }
}

TEST(Framing, DoesNotDependOnWhatAPlateSays) {
    render::Frame early = fitted(frameOf({.stats = true}), 480, 270);
    render::Frame late = fitted(frameOf({.stats = true}, 40), 480, 270);
    EXPECT_EQ(early.camera.from, late.camera.from);
    EXPECT_EQ(early.camera.lookAt, late.camera.lookAt);
}

}  // namespace
}  // namespace demos
