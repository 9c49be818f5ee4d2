// The image of the bodies in the floor.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "render/mirrored_view.h"
#include "render/palette.h"
#include "render/renderer.h"

namespace render {
namespace {

constexpr int kMirrorWidth = 160, kMirrorHeight = 90;

/// A red box, `above` the floor (m), with the sun to its right.
Frame boxOverFloor(float reflection, float above = 0.0f) {
    Frame frame;
    frame.camera = {{0, 1.2f, 6}, {0, 0.3f, 0}, {0, 1, 0}, 35};
    frame.look.reflection = reflection;
    frame.look.lineStrength = 0.0f;
    frame.look.sunDirection = {1.0f, 0.5f, 0.3f};
    frame.grounds.push_back({});
    Solid box;
    box.position = {0, 0.5f + above, 0};
    box.color = fromHex(0xc03020);
    frame.solids.push_back(box);
    return frame;
}

RendererSettings mirrorSettings(Finish finish = Finish::standard) {
    RendererSettings settings;
    settings.width = kMirrorWidth, settings.height = kMirrorHeight;
    settings.finish = finish;
    return settings;
}

Image drawnAlone(const Frame& frame, Finish finish = Finish::standard) {
    return Renderer(mirrorSettings(finish)).draw(frame);
}

/// Where the floor shows the image of a point of the front face, at this height of the box.
std::array<int, 2> imageOf(const Frame& frame, float height, float x = 0.0f) {
    const Vec3 point(x, -(frame.solids[0].position.y() - 0.5f + height), 0.5f);
    const float aspect = static_cast<float>(kMirrorWidth) / kMirrorHeight;
    const Projected at = project(makeView(frame.camera, aspect), point, kMirrorWidth, kMirrorHeight);
    return {static_cast<int>(at.x), static_cast<int>(at.y)};
}

/// Red minus blue: the floor is grey.
int rednessAt(const Image& image, const std::array<int, 2>& at) {
    const std::uint8_t* p = image.at(at[0], at[1]);
    return p[0] - p[2];
}

/// By how much the reflection makes the floor redder at the image of a point of the box.
int addedRed(float reflection, float above, float height) {
    const Frame plain = boxOverFloor(0.0f, above), glossy = boxOverFloor(reflection, above);
    const std::array<int, 2> at = imageOf(plain, height);
    return rednessAt(drawnAlone(glossy), at) - rednessAt(drawnAlone(plain), at);
}

TEST(Mirror, ShowsAPointWhereItsMirrorImageIs) {
    Ground slope;
    slope.normal = Vec3(0.1f, 1.0f, -0.2f).normalized();
    slope.offset = 0.3f;
    const View view = makeView({{3, 2, 5}, {0, 1, 0}, {0, 1, 0}, 35}, 16.0f / 9.0f);
    const View below = mirroredView(view, slope);
    for (const Vec3& point : {Vec3(0, 1, 0), Vec3(1, 0.8f, 2), Vec3(-1, 3, 0.5f)}) {
        const float height = slope.normal.dot(point) - slope.offset;
        const Vec3 image = point - 2.0f * height * slope.normal;
        const Projected a = project(below, point, 1280, 720), b = project(view, image, 1280, 720);
        EXPECT_NEAR(a.x, b.x, 0.01f);
        EXPECT_NEAR(a.y, b.y, 0.01f);
        EXPECT_NEAR(a.depth, b.depth, 1e-4f);
    }
}

TEST(Mirror, CutsOffWhatIsBelowTheFloor) {
    const Ground floor;
    const View below =
        mirroredView(makeView({{3, 2, 5}, {0, 1, 0}, {0, 1, 0}, 35}, 16.0f / 9.0f), floor);
    const auto isKept = [&below](const Vec3& point) {
        const Eigen::Vector4f clip = below.worldToClip() * point.homogeneous();
        return clip.z() > -clip.w() && clip.z() < clip.w();
    };
    EXPECT_TRUE(isKept({0, 0.01f, 0}));
    EXPECT_TRUE(isKept({-30, 20.0f, -30}));
    EXPECT_FALSE(isKept({0, -0.01f, 0}));
}

TEST(Mirror, TheFloorInFrontOfABodyTakesItsColour) {
    EXPECT_GE(addedRed(0.3f, 0.0f, 0.15f), 8);
    EXPECT_GT(addedRed(0.6f, 0.0f, 0.15f), addedRed(0.3f, 0.0f, 0.15f) + 5);
}

TEST(Mirror, FadesWithTheHeight) {
    EXPECT_LT(addedRed(0.5f, 0.0f, 0.8f), addedRed(0.5f, 0.0f, 0.15f) - 5);
    EXPECT_GT(addedRed(0.5f, 0.0f, 0.8f), 5);
}

TEST(Mirror, ABodyThatHoversHasItsImageApart) {
    const Frame plain = boxOverFloor(0.0f, 0.6f), glossy = boxOverFloor(0.5f, 0.6f);
    const std::array<int, 2> gap = imageOf(plain, -0.55f);
    const int before = rednessAt(drawnAlone(plain), gap), now = rednessAt(drawnAlone(glossy), gap);
    EXPECT_LE(std::abs(now - before), 2);
    EXPECT_GT(addedRed(0.5f, 0.6f, 0.2f), 5);
}

TEST(Mirror, AFloorWithNoImageOfABodyIsAsWithoutReflection) {
    const Image plain = drawnAlone(boxOverFloor(0.0f)), glossy = drawnAlone(boxOverFloor(1.0f));
    for (const int x : {3, 150})
        for (int y = 0; y < kMirrorHeight; ++y)
            for (int c = 0; c < 4; ++c)
                EXPECT_LE(std::abs(plain.at(x, y)[c] - glossy.at(x, y)[c]), 1) << x << "," << y;
}

// What hangs below the floor would otherwise seem to stand on it, upside down.
TEST(Mirror, ABodyBelowTheFloorHasNoImage) {
    const Image plain = drawnAlone(boxOverFloor(0.0f, -1.5f));
    const Image glossy = drawnAlone(boxOverFloor(1.0f, -1.5f));
    for (std::size_t i = 0; i < plain.pixels.size(); ++i)
        ASSERT_LE(std::abs(plain.pixels[i] - glossy.pixels[i]), 1) << i;
}

TEST(Mirror, GlassHasNoImage) {
    Frame plain = boxOverFloor(0.0f), glossy = boxOverFloor(1.0f);
    plain.solids[0].material = glossy.solids[0].material = Material::glass;
    const std::array<int, 2> at = imageOf(plain, 0.15f);
    EXPECT_LE(std::abs(rednessAt(drawnAlone(plain), at) - rednessAt(drawnAlone(glossy), at)), 1);
}

TEST(Mirror, ACameraBelowTheFloorSeesNone) {
    Frame plain = boxOverFloor(0.0f), glossy = boxOverFloor(1.0f);
    plain.camera.from.y() = glossy.camera.from.y() = -1.0f;
    EXPECT_EQ(drawnAlone(plain).pixels, drawnAlone(glossy).pixels);
}

TEST(Mirror, DraftsAndPicturesWithoutABackgroundHaveNone) {
    Frame plain = boxOverFloor(0.0f), glossy = boxOverFloor(1.0f);
    EXPECT_EQ(drawnAlone(plain, Finish::draft).pixels, drawnAlone(glossy, Finish::draft).pixels);
    plain.look.transparent = glossy.look.transparent = true;
    EXPECT_EQ(drawnAlone(plain).pixels, drawnAlone(glossy).pixels);
}

TEST(Mirror, AMeanOfMomentsHasItToo) {
    const std::array<int, 2> at = imageOf(boxOverFloor(0.0f), 0.15f);
    const auto redness = [&at](float reflection) {
        const std::vector<Frame> moments(3, boxOverFloor(reflection));
        return rednessAt(Renderer(mirrorSettings()).draw(std::span<const Frame>(moments)), at);
    };
    EXPECT_GE(redness(0.3f), redness(0.0f) + 8);
}

TEST(Mirror, ABodyThatMovesTakesItsImageAlong) {
    Frame before = boxOverFloor(0.5f), now = before;
    now.solids[0].position.x() = 0.7f;
    const Image alone = drawnAlone(now);
    Renderer renderer(mirrorSettings());
    renderer.draw(before);
    EXPECT_EQ(renderer.draw(now).pixels, alone.pixels);
    EXPECT_EQ(renderer.drawnShare(), 1.0);
}

}  // namespace
}  // namespace render
