// Golden frames: small pictures stored in tests/golden, drawn in the reproducible class of pixels.
// IMPULSE_UPDATE_GOLDEN=1 writes them again; check them before you commit them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "render/difference.h"
#include "render/encode/file.h"
#include "render/encode/png.h"
#include "render/encode/png_read.h"
#include "render/material.h"
#include "render/palette.h"
#include "render/renderer.h"
#include "tests/render/solids.h"

namespace render {
namespace {

constexpr int kGoldenWidth = 320, kGoldenHeight = 180;

RendererSettings small(int width = kGoldenWidth, int height = kGoldenHeight) {
    RendererSettings s;
    s.width = width, s.height = height;
    s.reproducible = true;
    return s;
}

/// A row of boxes, the topmost moved by `shift` (m), a ball, a capsule on a rod.
Frame still(float shift = 0.0f) {
    Frame frame;
    frame.camera = {{4, 3, 7}, {0, 1.1f, 0}, {0, 1, 0}, 35};
    frame.grounds.push_back({});
    for (int i = 0; i < 3; ++i) {
        Solid box;
        box.position = {i == 2 ? shift : 0.0f, 0.5f + static_cast<float>(i), 0};
        box.color = paletteColor(i);
        frame.solids.push_back(box);
    }
    Solid ball;
    ball.shape = SolidShape::sphere;
    ball.position = {1.6f, 0.5f, 0.4f};
    ball.color = heavyColor();
    frame.solids.push_back(ball);
    Solid capsule;
    capsule.shape = SolidShape::capsule;
    capsule.halfSize = {0.2f, 0.4f, 0.2f};
    capsule.position = {-1.6f, 1.4f, 0};
    capsule.color = paletteColor(4);
    frame.solids.push_back(capsule);
    frame.rods.push_back({{-1.6f, 1.8f, 0}, {-1.6f, 3.0f, 0}, 0.03f, jointColor()});
    return frame;
}

Frame annotated() {
    Frame frame = still();
    frame.markers.push_back({{0.5f, 1, 0.5f}, 3.5f, contactColor()});
    frame.arrows.push_back({{0, 0, 0.5f}, {0, 0.9f, 0.5f}, impulseColor()});
    Trail trail;
    for (int i = 0; i < 20; ++i)
        trail.points.push_back({1.6f, 0.5f + 0.1f * static_cast<float>(i), 0.4f});
    trail.color = paletteColor(5);
    frame.trails.push_back(trail);
    frame.texts.push_back({"t = 1.250 s   λ = 9.81 N s", Corner::topLeft, 30});
    frame.texts.push_back({"three boxes", Corner::bottomRight, 30});
    return frame;
}

/// A box and a ball of each; glass in front of the others.
Frame materials() {
    Frame frame;
    frame.camera = {{0, 2.6f, 9.0f}, {0, 0.8f, 0}};
    frame.look.grain = 0.2f;
    frame.grounds.push_back({});
    for (std::size_t i = 0; i < kMaterials; ++i) {
        Solid box;
        box.material = static_cast<Material>(i);
        box.color = fromHex(valuesOf(box.material).color);
        const auto column = static_cast<float>(i % 8);
        box.halfSize = {0.42f, 0.42f, 0.42f};
        box.position = {1.1f * (column - 3.5f), 0.42f, i < 8 ? 0.0f : 2.2f};
        Solid ball = box;
        ball.shape = SolidShape::sphere;
        ball.position += Vec3(i < 8 ? 0.0f : 1.2f, i < 8 ? 0.84f : 0.0f, 0.0f);
        frame.solids.push_back(box);
        frame.solids.push_back(ball);
    }
    return frame;
}

Image golden(const std::string& name, const Image& actual) {
    const std::filesystem::path path = std::filesystem::path(IMPULSE_GOLDEN_DIR) / (name + ".png");
    if (std::getenv("IMPULSE_UPDATE_GOLDEN")) writeFileAtomically(path, encodePng(actual));
    std::ifstream file(path, std::ios::binary);
    const std::vector<std::uint8_t> bytes((std::istreambuf_iterator<char>(file)), {});
    return decodePng(bytes);
}

/// There is one renderer: the first one in a process decides the class of pixels.
Renderer& renderer() {
    static Renderer one(small());
    return one;
}

void expectGolden(const std::string& name, const Frame& frame) {
    const Image actual = renderer().draw(frame);
    const Difference d = compare(golden(name, actual), actual);
    EXPECT_TRUE(samePicture(d, Gate{})) << name << ": worst window " << d.worstWindow << " at "
                                        << d.windowX << "," << d.windowY << ", worst SSIM "
                                        << d.worstSsim;
}

TEST(ShadowMap, GrowsWithThePictureWithinBounds) {
    const auto texels = [](int width, int height) { return shadowTexels(small(width, height)); };
    EXPECT_EQ(texels(192, 108), 512);
    EXPECT_EQ(texels(1280, 720), 2048);
    EXPECT_EQ(texels(720, 1280), 2048);
    EXPECT_EQ(texels(3840, 2160), 4096);
    RendererSettings own = small();
    own.shadowSize = 700;
    EXPECT_EQ(shadowTexels(own), 700);
}

TEST(GoldenPicture, StillLife) { expectGolden("still", still()); }
TEST(GoldenPicture, EverySolid) { expectGolden("solids", everySolid()); }
TEST(GoldenPicture, Materials) { expectGolden("materials", materials()); }
TEST(GoldenPicture, Annotated) { expectGolden("annotated", annotated()); }
TEST(GoldenPicture, DarkWithoutOcclusion) {
    Frame frame = still();
    frame.look.skyTop = frame.look.skyHorizon = frame.look.fog = fromHex(0x1b1d21);
    frame.look.ground = fromHex(0x2a2d33);
    frame.look.ambientOcclusion = false;
    frame.look.edges = false;
    expectGolden("dark", frame);
}

TEST(GoldenPicture, GlossyFloor) {
    Frame frame = still();
    frame.look.reflection = 0.4f;
    expectGolden("glossy", frame);
}

// The damage that the gate must find: a body one centimetre off, a missing shadow, a hidden body.
TEST(Gate, CatchesPlantedDamage) {
    const Image right = renderer().draw(still());
    EXPECT_FALSE(samePicture(compare(right, renderer().draw(still(0.01f))), Gate{}));
    Frame noShadow = still();
    noShadow.look.shadows = false;
    EXPECT_FALSE(samePicture(compare(right, renderer().draw(noShadow)), Gate{}));
    Frame hidden = still();
    hidden.solids.pop_back();
    EXPECT_FALSE(samePicture(compare(right, renderer().draw(hidden)), Gate{}));
}

/// The mean of a row's greens.
double meanOfRow(const Image& image, int y) {
    double sum = 0.0;
    for (int x = 0; x < image.width; ++x) sum += image.at(x, y)[1];
    return sum / image.width;
}

TEST(Renderer, DitheringSpreadsEachLevelOfASmoothGradient) {
    Frame frame;
    frame.camera = {{0, 5, 20}, {0, 12, 0}};  // the sky only
    const Image banded = renderer().draw(frame);
    frame.look.dither = true;
    const Image dithered = renderer().draw(frame);
    EXPECT_EQ(compare(banded, dithered).largest, 1);
    int whole = 0, between = 0;  // rows
    for (int y = 0; y < banded.height; ++y) {
        EXPECT_EQ(meanOfRow(banded, y), banded.at(0, y)[1]) << y;
        EXPECT_NEAR(meanOfRow(dithered, y), meanOfRow(banded, y), 0.6) << y;
        const double part = meanOfRow(dithered, y) - std::floor(meanOfRow(dithered, y));
        (part > 0.1 && part < 0.9 ? between : whole)++;
    }
    EXPECT_GT(between, whole);
    EXPECT_EQ(renderer().draw(frame).pixels, dithered.pixels);
}

TEST(Renderer, DrawsTheSameFrameTwiceToTheByte) {
    const Image first = renderer().draw(annotated());
    renderer().draw(still(1.0f));
    EXPECT_EQ(renderer().draw(annotated()).pixels, first.pixels);
}

// A second renderer in its own process with another number of threads draws the same pixels.
// The near plane would cut the ground below the picture's middle; nothing was drawn there, not even a background.
TEST(Renderer, ACameraCloseAboveTheGroundSeesItToTheLastRow) {
    for (const float height : {0.12f, 0.02f}) {
        Frame frame = still();
        frame.camera = {{0, height, 12}, {0, 0.6f, 0}, {0, 1, 0}, 60};
        const Image low = renderer().draw(frame);
        const std::uint8_t* const ground = low.at(0, kGoldenHeight * 2 / 3);
        for (int y = kGoldenHeight * 2 / 3; y < kGoldenHeight; ++y)
            for (const int x : {0, kGoldenWidth / 2, kGoldenWidth - 1}) {
                EXPECT_EQ(low.at(x, y)[3], 255) << x << ' ' << y;
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(low.at(x, y)[c], ground[c], 40) << x << ' ' << y;
            }
    }
}

TEST(Renderer, RefusesSizesItCannotDraw) {
    for (const auto& [w, h] : {std::pair{0, 10}, {10, 16385}, {-1, 10}}) {
        try {
            Renderer bad(small(w, h));
            FAIL() << w << "x" << h;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("16384"), std::string::npos);
        }
    }
}

TEST(Renderer, ACameraStraightAboveAndAnEmptySceneWork) {
    Frame frame = still();
    frame.camera.from = {0, 9, 0};
    frame.camera.lookAt = {0, 0, 0};
    EXPECT_NO_THROW(renderer().draw(frame));
    Frame ground;
    ground.grounds.push_back({});
    EXPECT_NO_THROW(renderer().draw(ground));
}

TEST(Renderer, NamesItsDriver) {
    EXPECT_NE(renderer().describe().find("Mesa"), std::string::npos);
}

Frame emptyFrame(const Color& sky) {
    Frame frame;
    frame.look.skyTop = frame.look.skyHorizon = frame.look.fog = sky;
    return frame;
}

TEST(EmptyPicture, IsAnErrorOnlyIfItIsBlackAndTheFirst) {
    Renderer grey(small()), black(small());
    EXPECT_NO_THROW(grey.draw(emptyFrame(fromHex(0x808080))));  // all bodies are too small to be seen
    EXPECT_NO_THROW(grey.draw(emptyFrame({0, 0, 0, 1})));
    try {
        black.draw(emptyFrame({0, 0, 0, 1}));
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("draws nothing"), std::string::npos);
    }
}

}  // namespace
}  // namespace render
