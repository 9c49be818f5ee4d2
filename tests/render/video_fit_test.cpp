// Films with a size limit.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "render/encode/video.h"
#include "render/error.h"
#include "tests/render/film_bytes.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using namespace film_bytes;
using render::Encoding;
using render::Fit;
using render::VideoWriter;

constexpr int kNoiseWidth = 128, kNoiseHeight = 96, kNoiseFrames = 12, kNoiseFps = 30;

/// Moving noise, which is hard for every codec, over a ramp.
render::Image noiseFrame(int number) {
    render::Image image{kNoiseWidth, kNoiseHeight,
                        std::vector<std::uint8_t>(4 * kNoiseWidth * kNoiseHeight, 255)};
    std::uint32_t noise = static_cast<std::uint32_t>(number) + 1;
    for (int y = 0; y < kNoiseHeight; ++y)
        for (int x = 0; x < kNoiseWidth; ++x)
            for (int c = 0; c < 3; ++c) {
                noise = noise * 1664525 + 1013904223;
                image.at(x, y)[c] = static_cast<std::uint8_t>(x + (noise >> 26));
            }
    return image;
}

class FitInto : public testing::Test {
protected:
    /// The writer's summary.
    std::string write(const std::string& name, const Fit& fit) const {
        VideoWriter film(folder_ / name, {kNoiseWidth, kNoiseHeight, kNoiseFps}, fit);
        for (int i = 0; i < kNoiseFrames; ++i) film.add(noiseFrame(i));
        film.close();
        return film.summary();
    }
    std::uintmax_t bytesOf(const std::string& name) const { return fs::file_size(folder_ / name); }
    std::ptrdiff_t filesLeft() const {
        return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
    }
    support::TemporaryFolder folder_;
};

TEST_F(FitInto, EveryFormatFindsARungBelowTheLimit) {
    NEED_FFMPEG();
    for (const std::string name : {"a.gif", "a.webp", "a.mp4", "a.webm", "a.apng"}) {
        write(name, {std::numeric_limits<std::uint64_t>::max(), {}, {}});
        const std::uintmax_t best = bytesOf(name);
        int refused = 0;
        Fit fit{best / 3, {}, [&](const std::string&) { ++refused; }};
        const std::string summary = write("small" + name, fit);
        EXPECT_LE(bytesOf("small" + name), best / 3) << name;
        EXPECT_GE(refused, 1) << name;
        EXPECT_NE(summary.find(": "), std::string::npos) << summary;
    }
    EXPECT_EQ(filesLeft(), 10);
}

/// A limit of exactly a rung's size is enough for it, one byte less is not.
TEST_F(FitInto, TheBestRungThatFitsIsTaken) {
    NEED_FFMPEG();
    const std::string best = write("best.gif", {1'000'000'000, {}, {}});
    EXPECT_NE(best.find("128x96, 30 frames/s, 256 colours"), std::string::npos) << best;
    const std::string same = write("same.gif", {bytesOf("best.gif"), {}, {}});
    EXPECT_EQ(same, best);
    EXPECT_EQ(contentOf(folder_ / "same.gif"), contentOf(folder_ / "best.gif"));
    const std::string next = write("next.gif", {bytesOf("best.gif") - 1, {}, {}});
    EXPECT_NE(next.find("128x96, 30 frames/s, 128 colours"), std::string::npos) << next;
}

TEST_F(FitInto, DroppedFramesLeaveTheTimeAsItWas) {
    NEED_FFMPEG();
    write("all.gif", {});
    const render::VideoFormat& gif = *render::videoFormatOf("x.gif");
    const std::vector<Encoding> ladder =
        render::ladderOf(gif, {kNoiseWidth, kNoiseHeight, kNoiseFps});
    const auto halved = std::find_if(ladder.begin(), ladder.end(),
                                     [](const Encoding& e) { return e.everyNth == 2; });
    ASSERT_NE(halved, ladder.end());
    std::uint64_t limit = bytesOf("all.gif");
    std::string summary;
    while (summary.find(" 15 frames/s") == std::string::npos && limit > 1000) {
        limit = limit * 4 / 5;
        summary = write("half.gif", {limit, {}, {}});
    }
    const std::vector<unsigned> delays = gifDelays(contentOf(folder_ / "half.gif"));
    ASSERT_EQ(delays.size(), static_cast<std::size_t>(kNoiseFrames / 2)) << summary;
    unsigned sum = 0;
    for (const unsigned delay : delays) sum += delay;
    EXPECT_NEAR(sum / 100.0, static_cast<double>(kNoiseFrames) / kNoiseFps, 0.021);
}

TEST_F(FitInto, WhatCannotFitIsReportedAndLeavesNothing) {
    NEED_FFMPEG();
    try {
        write("a.gif", {1000, {}, {}});
        FAIL() << "twelve frames of noise in 1000 bytes";
    } catch (const render::Error& error) {
        const std::string line = error.what();
        EXPECT_NE(line.find("even 32x24, 5 frames/s, 16 colours takes "), std::string::npos)
            << line;
        EXPECT_NE(line.find("more than 1.0 kB"), std::string::npos) << line;
    }
    EXPECT_EQ(filesLeft(), 0);
}

TEST_F(FitInto, ACancelledFilmLeavesNothing) {
    NEED_FFMPEG();
    EXPECT_THROW(write("a.gif", {0, [] { return true; }, {}}), render::Cancelled);
    EXPECT_THROW(write("a.webm", {1'000'000, [] { return true; }, {}}), render::Cancelled);
    EXPECT_EQ(filesLeft(), 0);
}

TEST_F(FitInto, FramesAreStoredWithoutAName) {
    NEED_FFMPEG();
    VideoWriter film(folder_ / "a.gif", {kNoiseWidth, kNoiseHeight, kNoiseFps});
    film.add(noiseFrame(0));
    EXPECT_EQ(filesLeft(), 1) << "the film's temporary name, and nothing else";
}

/// Transparent white next to dark: the edge between them must stay dark.
render::Image halfSeen(int number) {
    render::Image image = noiseFrame(number);
    for (int y = 0; y < kNoiseHeight; ++y)
        for (int x = 0; x < kNoiseWidth; ++x) {
            const bool seen = x > kNoiseWidth / 2;
            for (int c = 0; c < 3; ++c) {
                std::uint8_t& level = image.at(x, y)[c];
                level = seen ? static_cast<std::uint8_t>(level / 8) : std::uint8_t{255};
            }
            image.at(x, y)[3] = seen ? 255 : 0;
        }
    return image;
}

TEST_F(FitInto, WhatIsNotSeenDoesNotBleedIntoASmallerPicture) {
    NEED_FFMPEG();
    VideoWriter film(folder_ / "a.apng", {kNoiseWidth, kNoiseHeight, kNoiseFps, true},
                     {60'000, {}, {}});
    for (int i = 0; i < kNoiseFrames; ++i) film.add(halfSeen(i));
    film.close();
    int width = 0, height = 0;
    ASSERT_EQ(std::sscanf(film.summary().c_str(), "%*[^:]: %dx%d", &width, &height), 2);
    ASSERT_LT(width, kNoiseWidth) << film.summary() << ": the limit above should cost size";
    const std::vector<render::Image> frames = decoded(folder_ / "a.apng", width, height);
    ASSERT_FALSE(frames.empty());
    int halfCovered = 0;
    for (int x = 0; x < width; ++x) {
        const std::uint8_t* pixel = frames[0].at(x, height / 2);
        EXPECT_TRUE(pixel[3] == 0 || pixel[1] <= 45) << "column " << x;
        halfCovered += pixel[3] > 0 && pixel[3] < 255;
    }
    EXPECT_EQ(halfCovered, 1);
    EXPECT_EQ(frames[0].at(0, 0)[3], 0);
    EXPECT_EQ(frames[0].at(width - 1, 0)[3], 255);
}

TEST(Ladder, OnlyGoesDown) {
    for (const char* name : {"a.gif", "a.webp", "a.mp4", "a.webm", "a.apng"}) {
        const render::VideoFormat& format = *render::videoFormatOf(name);
        const std::vector<Encoding> ladder = render::ladderOf(format, {1280, 720, 30});
        EXPECT_GE(ladder.size(), 5u) << name;
        EXPECT_EQ(ladder.front().width, 1280);
        EXPECT_EQ(ladder.front().everyNth, 1);
        for (std::size_t i = 1; i < ladder.size(); ++i) {
            EXPECT_LE(ladder[i].width, ladder[i - 1].width) << name;
            EXPECT_GE(ladder[i].everyNth, ladder[i - 1].everyNth) << name;
            EXPECT_NE(ladder[i], ladder[i - 1]) << name;
        }
    }
}

TEST(Ladder, TakesAnySize) {
    for (const int side : {1, 2, 3, 17, 16384})
        for (const char* name : {"a.gif", "a.mp4"})
            for (const Encoding& encoding :
                 render::ladderOf(*render::videoFormatOf(name), {side, side, 1})) {
                EXPECT_GE(encoding.width, 1);
                EXPECT_EQ(encoding.everyNth, 1);
                const bool even = encoding.width % 2 == 0 && encoding.height % 2 == 0;
                EXPECT_TRUE(even || encoding.width == side || std::string(name) == "a.gif");
            }
}

TEST(Ladder, BytesAreReportedInThousands) {
    EXPECT_EQ(render::bytesText(999), "999 bytes");
    EXPECT_EQ(render::bytesText(1000), "1.0 kB");
    EXPECT_EQ(render::bytesText(7'640'000), "7.6 MB");
    EXPECT_EQ(render::bytesText(23'100'000), "23 MB");
    EXPECT_EQ(render::bytesText(999'999), "1.0 MB");
}

}  // namespace
