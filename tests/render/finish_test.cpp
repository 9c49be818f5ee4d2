// Finishes of a picture: drafts, transparent background, many moments in one.
#include <gtest/gtest.h>

#include "render/palette.h"
#include "render/renderer.h"

namespace render {
namespace {

constexpr int kFinishWidth = 192, kFinishHeight = 108;

RendererSettings settings(Finish finish = Finish::standard) {
    RendererSettings s;
    s.width = kFinishWidth, s.height = kFinishHeight;
    s.finish = finish;
    s.threads = 0;
    return s;
}

Frame boxAt(float x) {
    Frame frame;
    frame.camera = {{0, 2.5f, 9}, {0, 0.8f, 0}, {0, 1, 0}, 35};
    frame.grounds.push_back({});
    Solid box;
    box.position = {x, 0.8f, 0};
    box.color = fromHex(0xd62728);
    frame.solids.push_back(box);
    return frame;
}

/// The sum of the levels of all colour channels.
int levelsAt(const Image& image, int x, int y) {
    const std::uint8_t* p = image.at(x, y);
    return p[0] + p[1] + p[2];
}

constexpr int kMiddle = kFinishHeight / 2;

TEST(Transparent, OnlyBodiesAndTheirShadowsAreThere) {
    Frame frame = boxAt(0);
    frame.look.transparent = true;
    const Image image = Renderer(settings()).draw(frame);
    EXPECT_EQ(image.at(2, 2)[3], 0);                                 // the sky
    EXPECT_EQ(image.at(2, kFinishHeight - 3)[3], 0);                 // the ground
    EXPECT_EQ(image.at(kFinishWidth / 2, kMiddle)[3], 255);          // the box
    int shadow = 0, red = 0;
    for (int y = 0; y < kFinishHeight; ++y)
        for (int x = 0; x < kFinishWidth; ++x) {
            const std::uint8_t* p = image.at(x, y);
            shadow += p[3] > 20 && p[3] < 200 && p[0] < 30;
            red += p[3] > 0 && p[3] < 255 && p[0] > 120;  // an edge keeps the body's colour
        }
    EXPECT_GT(shadow, 50);
    EXPECT_GT(red, 10);
}

TEST(Transparent, TrailsAreSeenWhereNothingElseIs) {
    Frame frame = boxAt(0);
    frame.look.transparent = true;
    Trail trail;
    trail.points = {{-3, 2, 0}, {-2.5f, 2, 0}, {-2, 2, 0}};
    trail.color = fromHex(0x1f77d0);
    frame.trails.push_back(trail);
    const Image image = Renderer(settings()).draw(frame);
    int blue = 0;
    for (int y = 0; y < kFinishHeight / 2; ++y)
        for (int x = 0; x < kFinishWidth / 2 - 15; ++x)
            blue += image.at(x, y)[3] > 60 && image.at(x, y)[2] > 150;
    EXPECT_GT(blue, 3);
}

TEST(Draft, OfManyMomentsHasNoShadowsEither) {
    const std::vector<Frame> moments(4, boxAt(0));
    std::vector<Frame> plain = moments;
    for (Frame& frame : plain) frame.look.shadows = frame.look.ambientOcclusion = false;
    Renderer draft(settings(Finish::draft));
    EXPECT_EQ(draft.draw(moments).pixels, draft.draw(plain).pixels);
    EXPECT_NE(Renderer(settings()).draw(moments).pixels, Renderer(settings()).draw(plain).pixels);
}

/// Over all channels, in levels.
double meanDifference(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(a.pixels[i] - b.pixels[i]);
    return sum / static_cast<double>(a.pixels.size());
}

TEST(Draft, HasNeitherShadowsNorSamples) {
    const Image draft = Renderer(settings(Finish::draft)).draw(boxAt(0));
    RendererSettings one = settings();
    one.samples = 1;
    Frame plain = boxAt(0);
    plain.look.shadows = plain.look.ambientOcclusion = false;
    // Light is per vertex: no gloss, no rounded edges. The rest is the same.
    const double alike = meanDifference(draft, Renderer(one).draw(plain));
    EXPECT_LT(alike, 1.5);
    EXPECT_GT(meanDifference(draft, Renderer(one).draw(boxAt(0))), 1.5 * alike);
    RendererSettings many = settings(Finish::draft);
    many.samples = 16;
    EXPECT_EQ(draft.pixels, Renderer(many).draw(boxAt(0)).pixels);
}

TEST(Samples, AreNotSpentWhereThereIsNoBody) {
    Frame frame = boxAt(0);
    const Image four = Renderer(settings()).draw(frame);
    RendererSettings one = settings();
    one.samples = 1;
    const Image single = Renderer(one).draw(frame);
    int edge = 0;
    for (int y = 0; y < kFinishHeight; ++y)
        for (int x = 0; x < kFinishWidth; ++x) {
            const bool same = std::equal(four.at(x, y), four.at(x, y) + 4, single.at(x, y));
            EXPECT_TRUE(same || (x >= 60 && x <= 130)) << x << "," << y;
            edge += !same;
        }
    EXPECT_GT(edge, 20);
}

TEST(Moments, OfAFrameThatStandsStillLookLikeIt) {
    Renderer renderer(settings());
    const Frame frame = boxAt(0);
    const Image sharp = renderer.draw(frame);
    const Image mean = renderer.draw(std::vector<Frame>(16, frame));
    double difference = 0.0;
    for (std::size_t i = 0; i < sharp.pixels.size(); ++i)
        difference += std::abs(sharp.pixels[i] - mean.pixels[i]);
    EXPECT_LT(difference / static_cast<double>(sharp.pixels.size()), 2.0);  // levels
}

TEST(Moments, BlurWhatMovesAndNothingElse) {
    Renderer renderer(settings());
    std::vector<Frame> moving;
    for (int i = 0; i < 8; ++i) moving.push_back(boxAt(-1.0f + 0.25f * static_cast<float>(i)));
    const Image blurred = renderer.draw(moving);
    const Image first = renderer.draw(boxAt(-1.0f)), empty = renderer.draw(boxAt(50.0f));
    // The box covers this place in half of the moments: the level is between box and background.
    const int x = kFinishWidth / 2 - 20;
    EXPECT_GT(levelsAt(blurred, x, kMiddle), levelsAt(first, x, kMiddle) + 40);
    EXPECT_LT(levelsAt(blurred, x, kMiddle), levelsAt(empty, x, kMiddle) - 40);
    EXPECT_NEAR(levelsAt(blurred, 4, 4), levelsAt(empty, 4, 4), 4);
}

TEST(Moments, GiveTheSameBytesTwice) {
    Renderer renderer(settings());
    const std::vector<Frame> frames(5, boxAt(0.3f));
    const Image first = renderer.draw(frames);
    renderer.draw(boxAt(2));
    EXPECT_EQ(renderer.draw(frames).pixels, first.pixels);
}

TEST(Moments, WhatIsOutOfFocusIsSoft) {
    Renderer renderer(settings());
    Frame frame = boxAt(0);
    const Image sharp = renderer.draw(std::vector<Frame>(16, frame));
    frame.camera.aperture = 0.3f;
    frame.camera.focus = 3.0f;  // the box is 9 m away
    const Image soft = renderer.draw(std::vector<Frame>(16, frame));
    const auto steepest = [](const Image& image) {
        int most = 0;
        for (int x = 1; x < kFinishWidth; ++x)
            most = std::max(most, std::abs(levelsAt(image, x, kMiddle) -
                                           levelsAt(image, x - 1, kMiddle)));
        return most;
    };
    EXPECT_LT(steepest(soft), steepest(sharp) / 2);
}

TEST(Moments, TooManyOrNoneAreRefused) {
    Renderer renderer(settings());
    EXPECT_THROW(renderer.draw(std::vector<Frame>{}), Error);
    EXPECT_THROW(renderer.draw(std::vector<Frame>(257)), Error);
}

TEST(Stages, ComeInTheirOrder) {
    Renderer renderer(settings());
    std::vector<Stage> seen;
    renderer.observe([&](Stage stage) { seen.push_back(stage); });
    renderer.draw(boxAt(0));
    const std::vector<Stage> all = {Stage::depth,   Stage::occlusion, Stage::shadow,  Stage::scene,
                                    Stage::readBack, Stage::resolve, Stage::overlay, Stage::done};
    EXPECT_EQ(seen, all);
}

}  // namespace
}  // namespace render
