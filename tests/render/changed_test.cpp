// Frames of which only what changed is drawn, compared pixel by pixel with whole ones.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "render/changed_region.h"
#include "render/material.h"
#include "render/palette.h"
#include "render/renderer.h"
#include "tests/render/solids.h"

namespace render {
namespace {

constexpr int kFilmWidth = 190, kFilmHeight = 108;  // no multiples of a tile

Solid solidAt(SolidShape shape, const Vec3& at, int number) {
    Solid s;
    s.shape = shape;
    s.position = at;
    s.halfSize = {0.3f, 0.4f, 0.3f};
    if (shape == SolidShape::sphere) s.halfSize.y() = 0.3f;
    s.color = paletteColor(number);
    s.material = static_cast<Material>(number % static_cast<int>(kMaterials));
    return s;
}

/// Twenty solids of all shapes and materials, on a table and on the ground, and three rods.
Frame crowd() {
    Frame frame;
    frame.camera = {{5, 4, 8}, {0, 0.8f, 0}, {0, 1, 0}, 35};
    frame.grounds.push_back({});
    for (int i = 0; i < 20; ++i)
        frame.solids.push_back(
            solidAt(static_cast<SolidShape>(i % 5),
                    {static_cast<float>(i % 5) - 2.0f, 0.4f + 0.4f * static_cast<float>(i / 10),
                     0.9f * static_cast<float>(i / 5) - 1.5f},
                    i));
    Solid table;
    table.halfSize = {1.0f, 0.05f, 0.6f};
    table.position = {0.5f, 0.5f, 2.0f};
    frame.solids.push_back(table);
    for (int i = 0; i < 3; ++i)
        frame.rods.push_back({{-2.0f, 0.2f, 2.0f}, {static_cast<float>(i), 2.0f, 1.0f}, 0.02f, {}});
    return frame;
}

/// A few bodies move, turn, or change their colour; now and then much, mostly little.
void changeCrowd(Frame& frame, std::mt19937& random, int number) {
    const auto pick = [&random](std::size_t count) { return random() % count; };
    const auto shift = [&random]() -> Vec3 {
        const float x = static_cast<float>(random() % 100), y = static_cast<float>(random() % 100);
        const float z = static_cast<float>(random() % 100);
        return 0.002f * Vec3(x, y, z) - Vec3::Constant(0.1f);
    };
    for (std::size_t i = pick(3); i > 0; --i) {
        Solid& s = frame.solids[pick(20)];
        s.position += (number % 7 == 0 ? 8.0f : 1.0f) * shift();
        s.rotation = Eigen::AngleAxisf(0.1f, Vec3::UnitX()) * s.rotation;
    }
    if (number % 4 == 1) frame.solids[pick(20)].color = paletteColor(number);
    if (number % 5 == 2) frame.rods[pick(3)].to += shift();
    if (number % 3 == 0) return;
    if (frame.trails.empty()) frame.trails.push_back({{}, 4.0f, paletteColor(3)});
    frame.trails[0].points.push_back(frame.solids[4].position + 3.0f * shift());
}

std::vector<Frame> changingFilm(const Look& look, int count) {
    std::mt19937 random(7);
    std::vector<Frame> frames{crowd()};
    frames[0].look = look;
    for (int i = 1; i < count; ++i) {
        frames.push_back(frames.back());
        changeCrowd(frames.back(), random, i);
        frames.back().texts = {{"frame " + std::to_string(i)}};
        frames.back().markers.resize(1);
        frames.back().markers[0].position = frames.back().solids[2].position;
    }
    return frames;
}

struct DrawnFilm {
    std::vector<Image> images;
    double share = 0.0;  // mean of all but the first
};

DrawnFilm drawnFilm(const std::vector<Frame>& frames, RendererSettings settings, bool whole) {
    settings.width = kFilmWidth, settings.height = kFilmHeight;
    settings.wholeFrames = whole;
    Renderer renderer(settings);
    DrawnFilm result;
    for (const Frame& frame : frames) {
        result.images.push_back(renderer.draw(frame));
        result.share += renderer.drawnShare() / static_cast<double>(frames.size());
    }
    return result;
}

/// Where two pictures differ; "": nowhere.
std::string differenceOf(const Image& a, const Image& b) {
    int count = 0, x = 0, y = 0;
    for (int row = a.height - 1; row >= 0; --row)
        for (int column = a.width - 1; column >= 0; --column)
            if (!std::equal(a.at(column, row), a.at(column, row) + 4, b.at(column, row)))
                ++count, x = column, y = row;
    if (count == 0) return "";
    return std::to_string(count) + " pixels, the first at " + std::to_string(x) + "," +
           std::to_string(y);
}

/// `most`: of the pictures' area that is drawn, in the mean.
void expectSameFilm(const std::vector<Frame>& frames, const RendererSettings& settings,
                    double most) {
    const DrawnFilm kept = drawnFilm(frames, settings, false);
    const DrawnFilm whole = drawnFilm(frames, settings, true);
    for (std::size_t i = 0; i < frames.size(); ++i)
        EXPECT_EQ(differenceOf(kept.images[i], whole.images[i]), "") << "frame " << i;
    EXPECT_DOUBLE_EQ(whole.share, 1.0);
    EXPECT_LT(kept.share, most);
}

TEST(ChangedRegion, HasTheSamePixelsAsWholeFrames) {
    expectSameFilm(changingFilm({}, 24), {}, 0.8);
}

TEST(ChangedRegion, HasTheSamePixelsWithoutABackground) {
    Look look;
    look.transparent = true;
    look.edgePixels = 2.0f;
    expectSameFilm(changingFilm(look, 12), {}, 0.8);
}

TEST(ChangedRegion, HasTheSamePixelsIfDithered) {
    Look look;
    look.dither = true;
    expectSameFilm(changingFilm(look, 6), {}, 0.8);
}

TEST(ChangedRegion, HasTheSamePixelsWithoutShadowsAndInADraft) {
    Look look;
    look.shadows = false;
    RendererSettings settings;
    settings.samples = 1;
    expectSameFilm(changingFilm(look, 6), settings, 0.8);
    settings.finish = Finish::draft;
    expectSameFilm(changingFilm({}, 6), settings, 0.8);
}

TEST(ChangedRegion, IsNothingIfNothingChanges) {
    const Frame frame = crowd();
    Renderer renderer({.width = kFilmWidth, .height = kFilmHeight});
    const Image first = renderer.draw(frame);
    EXPECT_EQ(renderer.drawnShare(), 1.0);
    EXPECT_EQ(renderer.draw(frame).pixels, first.pixels);
    EXPECT_EQ(renderer.drawnShare(), 0.0);
}

TEST(ChangedRegion, IsEverythingIfTheViewOrTheLightOrTheNumberOfBodiesDiffers) {
    const Frame frame = crowd();
    const View view = makeView(frame.camera, 16.0f / 9.0f);
    const auto region = [&](const Frame& now) {
        return changedRegion(frame, now, view, 160, 90, nullptr);
    };
    EXPECT_TRUE(region(frame).has_value());
    Frame now = frame;
    now.camera.from.x() += 0.001f;
    EXPECT_FALSE(region(now).has_value());
    now = frame;
    now.look.sunDirection.x() += 0.001f;
    EXPECT_FALSE(region(now).has_value());
    now = frame;
    now.solids.pop_back();
    EXPECT_FALSE(region(now).has_value());
}

}  // namespace
}  // namespace render
