// Materials: their pictures, what is seen through glass, and what data passes say of it.
#include "render/material.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"

namespace render {
namespace {

constexpr int kWidth = 192, kHeight = 108;

RendererSettings smallSettings(Finish finish = Finish::standard) {
    RendererSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.finish = finish;
    settings.threads = 0;
    return settings;
}

/// A box of 3 x 1 x 1 m.
Frame boxOf(Material material) {
    Frame frame;
    frame.camera = {{0.0f, 1.0f, 6.0f}, {0.0f, 0.5f, 0.0f}};
    frame.look.grain = 0.75f;  // 23 pixels
    frame.look.edges = false;
    frame.grounds.push_back({});
    Solid box;
    box.halfSize = {1.5f, 0.5f, 0.5f};
    box.position = {0, 0.5f, 0};
    box.color = {0.5f, 0.4f, 0.3f, 1.0f};
    box.material = material;
    box.id = 7;
    frame.solids.push_back(box);
    return frame;
}

/// Mean and deviation of a channel in the middle of the box's front.
struct Spread {
    double mean = 0.0, deviation = 0.0;
};
Spread frontOf(const Image& image, std::size_t channel) {
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (int y = kHeight / 2 - 8; y < kHeight / 2 + 8; ++y)
        for (int x = kWidth / 2 - 30; x < kWidth / 2 + 30; ++x, ++count) {
            const double level = image.pixels[4 * static_cast<std::size_t>(y * kWidth + x) + channel];
            sum += level;
            squares += level * level;
        }
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(squares / count - mean * mean, 0.0))};
}

Spread frontOf(Material material) {
    static Renderer renderer(smallSettings());
    return frontOf(renderer.draw(boxOf(material)), 0);
}

TEST(Material, PatternsAreSeenAndKeepTheColour) {
    const Spread plain = frontOf(Material::plastic);
    EXPECT_LT(plain.deviation, 3.0);
    for (const Material material : {Material::wood, Material::brick, Material::stone, Material::felt}) {
        const Spread spread = frontOf(material);
        EXPECT_GT(spread.deviation, 1.5 * plain.deviation + 1.0) << valuesOf(material).name;
        EXPECT_NEAR(spread.mean, plain.mean, 14.0) << valuesOf(material).name;
    }
    EXPECT_LT(frontOf(Material::paper).deviation, frontOf(Material::stone).deviation);
}

TEST(Material, SteelShowsTheRoom) {
    Frame frame = boxOf(Material::steel);
    frame.solids[0].shape = SolidShape::sphere;
    frame.solids[0].halfSize.setConstant(1.0f);
    Renderer renderer(smallSettings());
    const Image steel = renderer.draw(frame);
    const auto level = [&steel](int y) {
        return static_cast<int>(steel.pixels[4 * static_cast<std::size_t>(y * kWidth + kWidth / 2)]);
    };
    // The upper half mirrors the bright back wall, the lower half the floor.
    EXPECT_GT(level(kHeight / 2 - 14), level(kHeight / 2 + 14) + 30);
}

TEST(Material, GlassIsSeenThroughAndHidesNothing) {
    Renderer renderer(smallSettings());
    Frame empty = boxOf(Material::glass), glass = empty, solid = boxOf(Material::paper);
    empty.solids.clear();
    const double without = frontOf(renderer.draw(empty), 0).mean;
    Solid ball;
    ball.shape = SolidShape::sphere;
    ball.halfSize.setConstant(0.8f);
    ball.position = {0, 0.6f, -3.0f};
    ball.color = {0.0f, 0.0f, 0.0f, 1.0f};
    const double clear = frontOf(renderer.draw(glass), 0).mean;
    const double wall = frontOf(renderer.draw(solid), 0).mean;
    glass.solids.push_back(ball);
    solid.solids.push_back(ball);
    EXPECT_LT(frontOf(renderer.draw(glass), 0).mean, clear - 15.0);  // the black ball is seen
    EXPECT_NEAR(frontOf(renderer.draw(solid), 0).mean, wall, 1.0);
    EXPECT_LT(std::abs(clear - without), 60.0);
}

TEST(Material, TheOrderOfBodiesDoesNotMatterForGlass) {
    Frame frame = boxOf(Material::glass);
    frame.solids.push_back(boxOf(Material::wood).solids[0]);
    frame.solids[1].position.z() = -3.0f;
    Frame other = frame;
    std::swap(other.solids[0], other.solids[1]);
    Renderer renderer(smallSettings());
    const Spread one = frontOf(renderer.draw(frame), 0), two = frontOf(renderer.draw(other), 0);
    EXPECT_NEAR(one.mean, two.mean, 4.0);  // each body has its own part of a pattern
}

TEST(Material, ATransparentPictureKeepsGlassTranslucent) {
    Frame frame = boxOf(Material::glass);
    frame.grounds.clear();
    frame.look.transparent = true;
    Renderer renderer(smallSettings());
    const double alpha = frontOf(renderer.draw(frame), 3).mean;
    EXPECT_GT(alpha, 50.0);
    EXPECT_LT(alpha, 200.0);
}

TEST(Material, DraftsShowTheColourAlone) {
    Renderer renderer(smallSettings(Finish::draft));
    EXPECT_LT(frontOf(renderer.draw(boxOf(Material::stone)), 0).deviation, 3.0);
}

TEST(Material, GlassIsSeenThroughInDraftsToo) {
    Renderer renderer(smallSettings(Finish::draft));
    Frame glass = boxOf(Material::glass);
    const double clear = frontOf(renderer.draw(glass), 0).mean;
    Solid wall = boxOf(Material::paper).solids[0];
    wall.position.z() = -3.0f;
    wall.color = {0.0f, 0.0f, 0.0f, 1.0f};
    glass.solids.push_back(wall);
    EXPECT_LT(frontOf(renderer.draw(glass), 0).mean, clear - 30.0);  // the black wall is seen
}

TEST(Material, ValuesAreThoseOfTheEnum) {
    EXPECT_EQ(valuesOf(Material::glass).name, "glass");
    EXPECT_EQ(valuesOf(Material::wood).name, "wood");
    EXPECT_EQ(indexOf(Material::glass) + 1, kMaterials);  // glass is the last: InstanceList::of
    for (const MaterialValues& values : kMaterialTable) {
        EXPECT_GE(values.roughness, 0.0f);
        EXPECT_LE(values.roughness, 1.0f);
        EXPECT_EQ(values.alpha < 1.0f, values.name == "glass");
    }
}

}  // namespace
}  // namespace render
