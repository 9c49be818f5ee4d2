// Marks over a picture with known depths: only nearer surfaces hide them.
#include "render/overlay.h"

#include <gtest/gtest.h>

#include "render/label_places.h"
#include "render/palette.h"
#include "tests/render/solids.h"

namespace render {
namespace {

constexpr int kSize = 200;

/// A white picture of a wall at `distance` m from the camera, which looks along -z from the origin.
struct Scene {
    Image image;
    DepthMap depth;
    SurfaceMap surfaces;
    Frame frame;
    View view;

    explicit Scene(float distance) {
        frame.camera = {{0, 0, 0}, {0, 0, -10}, {0, 1, 0}, 90};
        view = makeView(frame.camera, 1.0f);
        image.width = image.height = kSize;
        image.pixels.assign(4u * kSize * kSize, 255);
        depth.width = depth.height = kSize / 2;  // half size, as in the renderer
        depth.meters.assign(kSize * kSize / 4, distance);
        Solid& wall = frame.solids.emplace_back();
        wall.halfSize = {1000, 1000, 0.5f};
        wall.position = {0, 0, -distance - 0.5f};
        surfaces = {kSize, kSize, std::vector<std::int32_t>(kSize * kSize, packedSurface(0, 5))};
    }
    /// The amount of ink, in pixels.
    double draw() {
        drawOverlays(image, frame, view, {depth, surfaces});
        double sum = 0.0;
        for (std::size_t i = 0; i < image.pixels.size(); i += 4) sum += 255.0 - image.pixels[i + 1];
        return sum / 255.0;
    }
};

const Color kBlack{0, 0, 0, 1};

TEST(Overlay, DepthsOfAnotherSizeAreFoundAtTheSamePlace) {
    Scene scene(7.0f);
    scene.depth.meters[99 * kSize / 2 + 50] = 3.0f;  // column 50, row 99
    EXPECT_EQ(metersAt(scene.depth, scene.image, 101, 199), 3.0f);
    EXPECT_EQ(metersAt(scene.depth, scene.image, 102, 199), 7.0f);
    EXPECT_EQ(metersAt(scene.depth, scene.image, 199, 199), 7.0f);
}

TEST(Overlay, AMarkerIsSeenBeforeAWallAndNotBehindIt) {
    Scene before(10), behind(10), within(10);
    before.frame.markers.push_back({{0, 0, -9}, 10.0f, kBlack});
    behind.frame.markers.push_back({{0, 0, -11}, 10.0f, kBlack});
    within.frame.markers.push_back({{0, 0, -11}, 10.0f, kBlack});
    within.frame.markers.back().reach = 1.0f;  // its own body's surface
    EXPECT_GT(before.draw(), 5.0);
    EXPECT_EQ(behind.draw(), 0.0);
    EXPECT_GT(within.draw(), 5.0);
}

TEST(Overlay, AMarkerIsNoLargerThanItsBodyAllows) {
    Scene any(20), small(20);
    any.frame.markers.push_back({{0, 0, -10}, 12.0f, kBlack});
    small.frame.markers.push_back({{0, 0, -10}, 12.0f, kBlack});
    small.frame.markers.back().largest = 0.15f;  // m: 1.5 pixels, as 10 m away 1 m is 10 pixels
    const double all = any.draw(), little = small.draw();
    EXPECT_NEAR(little, 3.14159 * 1.5 * 1.5, 1.0);
    EXPECT_GT(all, 2.0 * little);
}

TEST(Overlay, ACentreOfMassIsHalfInkHalfWhite) {
    Scene scene(20);
    Marker marker{{0, 0, -10}, 90.0f, kBlack};
    marker.shape = MarkerShape::quartered;
    scene.frame.markers.push_back(marker);
    scene.draw();
    const auto at = [&](int dx, int dy) {
        return scene.image.at(kSize / 2 + dx, kSize / 2 + dy)[0] < 128;
    };
    EXPECT_NE(at(5, 5), at(-5, 5));
    EXPECT_EQ(at(5, 5), at(-5, -5));
    EXPECT_EQ(at(5, -5), at(-5, 5));
}

TEST(Overlay, AnArrowIsFaintWhereItStartsBehindSomething) {
    Scene before(20), behind(9.5f);
    for (Scene* scene : {&before, &behind})
        scene->frame.arrows.push_back({{-5, 0, -10}, {5, 0, -10}, kBlack});
    const double full = before.draw(), faint = behind.draw();
    EXPECT_GT(full, 50.0);
    EXPECT_GT(faint, 0.15 * full);
    EXPECT_LT(faint, 0.5 * full);
}

TEST(Overlay, ANameBesideItsPointCoversNeitherMarksNorNames) {
    Scene scene(20);
    scene.frame.arrows.push_back({{-5, 0, -10}, {5, 0, -10}, kBlack});
    scene.frame.labels.push_back({"p", {0, 0, -10}});
    scene.frame.labels.back().beside = true;
    const CornerLayout corners = layoutCorners(scene.frame, kSize, kSize);
    LabelPlaces places(scene.image, scene.frame, scene.view, corners);
    const Box wanted{80, 92, 40, 16};  // over the arrow, which is at y = 100
    std::vector<Box> taken;
    for (int i = 0; i < 4; ++i) {
        Box box = wanted;
        ASSERT_TRUE(places.takeBeside(box)) << i;
        EXPECT_TRUE(box.y > 100 || box.y + box.height < 100) << i;
        EXPECT_NEAR(box.x + box.width / 2, 100, 60);
        for (const Box& other : taken) EXPECT_FALSE(other.overlaps(box)) << i;
        taken.push_back(box);
    }
    Box large{0, 0, kSize + 1, 16};
    EXPECT_FALSE(places.takeBeside(large));
}

TEST(Overlay, ALongNameStandsBesideTheBodies) {
    Scene scene(20);
    scene.frame.labels.push_back({"r", {0, 0, -10}});
    scene.frame.labels.back().beside = true;
    const CornerLayout corners = layoutCorners(scene.frame, kSize, kSize);
    LabelPlaces places(scene.image, scene.frame, scene.view, corners);
    const auto pixelsOf = [&](const Vec3& point) { return project(scene.view, point, kSize, kSize); };
    const std::vector<Vec3> body = {{-1, -4, -10}, {1, 4, -10}};
    const float left = pixelsOf(body[0]).x, right = pixelsOf(body[1]).x;
    for (int i = 0; i < 6; ++i) {
        Box box{95, 92, 30, 16};
        ASSERT_TRUE(places.takeOutside(box, body, scene.view)) << i;
        EXPECT_TRUE(box.x + box.width < left || box.x > right) << i;
    }
    // Nothing is free beside what fills the picture.
    Box box{95, 92, 30, 16};
    EXPECT_FALSE(places.takeOutside(box, {{-99, -99, -10}, {99, 99, -10}}, scene.view));
    EXPECT_FALSE(places.takeOutside(box, {{0, 0, 10}}, scene.view)) << "behind the camera";
}

TEST(Overlay, ANameHasASubscript) {
    Scene plain(20), with(20);
    for (Scene* scene : {&plain, &with}) scene->frame.labels.push_back({"p", {0, 0, -10}});
    with.frame.labels[0].subscript = "b";
    EXPECT_GT(with.draw(), 1.2 * plain.draw());
}

TEST(Overlay, ALineIsCutAtTheCameraAndFaintBehindThings) {
    Scene before(40), behind(5);
    for (Scene* scene : {&before, &behind})
        scene->frame.lines.push_back({{-5, 0.3f, -10}, {5, 0.3f, -10}, 2.0f, kBlack});
    const double full = before.draw();
    EXPECT_NEAR(full, 100.0, 10.0);  // one pixel wide, since the picture is small
    EXPECT_LT(behind.draw(), 0.4 * full);
    Scene through(40);
    through.frame.lines.push_back({{1, 1, 50}, {1, 1, -20}, 2.0f, kBlack});
    EXPECT_GT(through.draw(), 10.0);
}

Solid ghostAt(SolidShape shape, float z) {
    Solid ghost;
    ghost.shape = shape;
    ghost.halfSize = {1, 1, 1};
    if (shape == SolidShape::capsule) ghost.halfSize = {0.5f, 0.5f, 0.5f};
    if (shape == SolidShape::mesh) ghost.mesh = octahedron(1.0f);
    ghost.position = {0, 0, z};
    ghost.color = {0, 0, 0, 0.4f};
    return ghost;
}

TEST(Ghosts, CoverTheirSilhouetteAndAreHiddenByWhatIsInFront) {
    for (const SolidShape shape :
         {SolidShape::box, SolidShape::sphere, SolidShape::capsule, SolidShape::cylinder,
          SolidShape::cone, SolidShape::mesh}) {
        Scene open(40), hidden(5);
        open.frame.ghosts.push_back(ghostAt(shape, -10));
        hidden.frame.ghosts.push_back(ghostAt(shape, -10));
        open.draw();
        EXPECT_LT(open.image.at(kSize / 2, kSize / 2)[0], 200);
        EXPECT_GT(open.image.at(kSize / 2, kSize / 2)[0], 100);  // translucent
        EXPECT_EQ(open.image.at(kSize / 2 + 14, kSize / 2)[0], 255);
        EXPECT_EQ(hidden.draw(), 0.0);
    }
}

TEST(Ghosts, ASphereIsAsLargeAsItsConeOfSight) {
    Scene scene(40);
    scene.frame.ghosts.push_back(ghostAt(SolidShape::sphere, -2));
    scene.frame.ghosts.back().color.a = 1.0f;
    // sin = 1/2, tan = 0.5774 of the half picture
    const double radius = 0.5774 * kSize / 2;
    double pixels = 0;
    scene.draw();
    for (std::size_t i = 0; i < scene.image.pixels.size(); i += 4)
        pixels += scene.image.pixels[i] < 128;
    EXPECT_NEAR(pixels, 3.14159 * radius * radius, 0.02 * pixels);
}

TEST(Ghosts, OfABarThatHidesPartsOfItselfHaveItsOutline) {
    Scene scene(40);
    Solid ghost = solidOf(angleBar(), {0, 0, -10}, {0, 0, 0, 1});
    scene.frame.ghosts.push_back(ghost);
    scene.draw();
    const auto seen = [&scene](float x, float y) {  // at its front, 9.5 m away
        const float scale = 0.5f * kSize / 9.5f;
        return scene.image.at(static_cast<int>(0.5f * kSize + scale * x),
                              static_cast<int>(0.5f * kSize - scale * y))[0];
    };
    EXPECT_LT(seen(-0.7f, 0.8f), 128);
    EXPECT_LT(seen(0.8f, -0.7f), 128);
    EXPECT_EQ(seen(0.5f, 0.0f), 255);  // within the hull of its corners
}

TEST(Ghosts, AroundTheCameraAreLeftOut) {
    Scene scene(40);
    scene.frame.ghosts.push_back(ghostAt(SolidShape::box, 0));
    EXPECT_EQ(scene.draw(), 0.0);
}

TEST(Labels, TheNearestIsPlacedAndNoneCoversAnother) {
    Scene one(40), crowd(40);
    one.frame.labels.push_back({"body", {0, 0, -9}});
    const double single = one.draw();
    EXPECT_GT(single, 10.0);
    for (int i = 0; i < 40; ++i) crowd.frame.labels.push_back({"body", {0, 0, -10}});
    crowd.frame.labels.push_back({"body", {0, 0, -9}});
    // At its place, above it and below it.
    EXPECT_NEAR(crowd.draw(), 3.0 * single, 0.01 * single);
}

TEST(Labels, OfHiddenBodiesAreLeftOut) {
    Scene scene(5);
    scene.frame.labels.push_back({"body", {0, 0, -10}, 1.0f});
    EXPECT_EQ(scene.draw(), 0.0);
}

TEST(Overlay, AnEmptyFrameNeedsNoDepthAndDrawsNothing) {
    Scene scene(5);
    EXPECT_FALSE(needsDepth(scene.frame));
    EXPECT_EQ(scene.draw(), 0.0);
    scene.frame.labels.push_back({"body", {0, 0, -10}});
    EXPECT_TRUE(needsDepth(scene.frame));
}

}  // namespace
}  // namespace render
