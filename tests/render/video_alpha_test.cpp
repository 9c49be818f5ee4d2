// What a film file preserves of its frames: alpha, rate, loop, the first picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "render/encode/video.h"
#include "render/error.h"
#include "tests/render/film_bytes.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using namespace film_bytes;
using render::VideoWriter;

constexpr int kFilmWidth = 64, kFilmHeight = 48, kFilmFrames = 10;
constexpr std::uint8_t kRed[] = {200, 60, 40, 255}, kGlass[] = {30, 40, 220, 128};

void fill(render::Image& image, int x0, int x1, int y0, int y1, const std::uint8_t (&color)[4]) {
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) std::copy_n(color, 4, image.at(x, y));
}

/// Transparent on top, glass from row 32 down, and a red square that moves one pixel per frame.
render::Image filmFrame(int number) {
    render::Image image{kFilmWidth, kFilmHeight,
                        std::vector<std::uint8_t>(4 * kFilmWidth * kFilmHeight)};
    fill(image, 0, kFilmWidth, 32, kFilmHeight, kGlass);
    fill(image, number, number + 24, 4, 28, kRed);
    return image;
}

class FilmFile : public testing::Test {
protected:
    fs::path write(const char* name, int fps, bool alpha) const {
        VideoWriter film(folder_ / name, {kFilmWidth, kFilmHeight, fps, alpha});
        for (int i = 0; i < kFilmFrames; ++i) film.add(filmFrame(i));
        film.close();
        return folder_ / name;
    }
    support::TemporaryFolder folder_;
};

void expectColor(const render::Image& image, int x, int y, const std::uint8_t (&color)[4],
                 int tolerance, const std::string& where) {
    for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(image.at(x, y)[c], color[c], tolerance)
            << where << " at " << x << ", " << y << ", channel " << c;
}

TEST_F(FilmFile, KeepsAlphaInStraightForm) {
    NEED_FFMPEG();
    for (const char* name : {"a.webm", "a.apng", "a.gif"}) {
        const std::vector<render::Image> frames =
            decoded(write(name, 25, true), kFilmWidth, kFilmHeight);
        ASSERT_EQ(frames.size(), static_cast<std::size_t>(kFilmFrames)) << name;
        // VP9 at crf 24 is a few levels off, the other two are exact
        const bool exact = fs::path(name).extension() != ".webm";
        for (const int i : {0, kFilmFrames - 1}) {
            expectColor(frames[i], i + 12, 16, kRed, exact ? 0 : 6, name);
            EXPECT_LE(frames[i].at(i + 40, 4)[3], 4) << name;
            EXPECT_LE(frames[i].at(60, 2)[3], 4) << name;
            if (fs::path(name).extension() == ".gif")  // on or off: 128 is on
                EXPECT_EQ(frames[i].at(32, 40)[3], 255);
            else
                expectColor(frames[i], 32, 40, kGlass, exact ? 0 : 6, name);
        }
    }
}

unsigned threeBytes(const std::string& bytes, std::size_t at) {
    return byteAt(bytes, at) + 256 * byteAt(bytes, at + 1) + 65536 * byteAt(bytes, at + 2);
}

/// The frame at `at` (its "ANMF") of an animated WebP as a separate WebP: ffmpeg of 2022 reads only
/// these. ANMF size(4) x/2 y/2 width-1 height-1 milliseconds (3 each) flags(1), then the picture's
/// chunks.
std::string pictureAt(const std::string& webp, std::size_t at) {
    const std::string chunks = webp.substr(at + 24, threeBytes(webp, at + 4) - 16);
    const std::string head = std::string("VP8X\x0a\0\0\0\x10\0\0\0", 12) + webp.substr(at + 14, 6);
    const std::size_t length = 4 + head.size() + chunks.size();
    std::string all = "RIFF";
    for (int i = 0; i < 4; ++i) all += static_cast<char>(length >> (8 * i) & 0xffu);
    return all + "WEBP" + head + chunks;
}

TEST_F(FilmFile, AWebpKeepsAlphaToo) {
    NEED_FFMPEG();
    const std::string webp = contentOf(write("a.webp", 25, true));
    const std::size_t first = find(webp, "ANMF");
    std::ofstream(folder_ / "first.webp", std::ios::binary) << pictureAt(webp, first);
    // empty rows and columns at the edges are left out
    const int left = static_cast<int>(2 * threeBytes(webp, first + 8));
    const int top = static_cast<int>(2 * threeBytes(webp, first + 11));
    const int width = static_cast<int>(threeBytes(webp, first + 14)) + 1;
    const int height = static_cast<int>(threeBytes(webp, first + 17)) + 1;
    ASSERT_EQ(left + width, kFilmWidth);
    ASSERT_EQ(top + height, kFilmHeight);
    const std::vector<render::Image> frames = decoded(folder_ / "first.webp", width, height);
    ASSERT_EQ(frames.size(), 1u);
    expectColor(frames[0], 12 - left, 16 - top, kRed, 8, "webp");  // quality 90: alpha is exact
    EXPECT_EQ(frames[0].at(60 - left, 16 - top)[3], 0);
    EXPECT_EQ(frames[0].at(32 - left, 40 - top)[3], kGlass[3]);
}

TEST_F(FilmFile, WithoutAlphaTheFourthByteIsIgnored) {
    NEED_FFMPEG();
    for (const char* name : {"a.webm", "a.apng", "a.gif", "a.mp4"}) {
        const std::vector<render::Image> frames =
            decoded(write(name, 25, false), kFilmWidth, kFilmHeight);
        ASSERT_EQ(frames.size(), static_cast<std::size_t>(kFilmFrames)) << name;
        EXPECT_EQ(frames[0].at(60, 2)[3], 255) << name;
        EXPECT_NEAR(frames[0].at(32, 40)[2], kGlass[2], 8) << name;
    }
}

TEST_F(FilmFile, AnMp4WithAlphaIsRefusedBeforeTheFirstFrame) {
    try {
        VideoWriter(folder_ / "a.mp4", {kFilmWidth, kFilmHeight, 25, true});
        FAIL() << "it took the film";
    } catch (const render::Error& error) {
        EXPECT_NE(std::string(error.what())
                      .find("a .mp4 holds no alpha; use .webm, .webp, .apng or .gif"),
                  std::string::npos)
            << error.what();
    }
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(FilmFile, PlaysForEver) {
    NEED_FFMPEG();
    const std::string gif = contentOf(write("a.gif", 25, false));
    const std::size_t loop = find(gif, "NETSCAPE2.0");  // then 03 01 count(2)
    EXPECT_EQ(byteAt(gif, loop + 13) + byteAt(gif, loop + 14), 0u);
    const std::string apng = contentOf(write("a.apng", 25, false));
    const std::size_t control = find(apng, "acTL");  // frames(4) plays(4)
    EXPECT_EQ(byteAt(apng, control + 7), static_cast<unsigned>(kFilmFrames));
    EXPECT_EQ(byteAt(apng, control + 11), 0u);
    const std::string webp = contentOf(write("a.webp", 25, false));
    const std::size_t animation = find(webp, "ANIM");  // size(4) background(4) loop(2)
    EXPECT_EQ(byteAt(webp, animation + 12) + byteAt(webp, animation + 13), 0u);
}

/// Delays are in hundredths, which do not divide a second by 30: three, three, four.
TEST_F(FilmFile, AGifKeepsTimeOverAll) {
    NEED_FFMPEG();
    for (const int fps : {10, 15, 25, 30, 50}) {
        const std::string name = "at" + std::to_string(fps) + ".gif";
        const std::vector<unsigned> delays = gifDelays(contentOf(write(name.c_str(), fps, false)));
        ASSERT_EQ(delays.size(), static_cast<std::size_t>(kFilmFrames)) << name;
        const double seconds = std::accumulate(delays.begin(), delays.end(), 0u) / 100.0;
        EXPECT_NEAR(seconds, static_cast<double>(kFilmFrames) / fps, 0.011) << name;
        EXPECT_GE(*std::min_element(delays.begin(), delays.end()), 2u) << "browsers slow it down";
    }
}

TEST_F(FilmFile, TheOthersHaveTheRateExactly) {
    NEED_FFMPEG();
    // fcTL: sequence width height x y (4 each), delay numerator and denominator (2 each)
    const std::string apng = contentOf(write("a.apng", 30, false));
    const std::size_t frameControl = find(apng, "fcTL") + 4 + 20;
    const unsigned up = 256 * byteAt(apng, frameControl) + byteAt(apng, frameControl + 1);
    const unsigned down = 256 * byteAt(apng, frameControl + 2) + byteAt(apng, frameControl + 3);
    EXPECT_EQ(up * 30, down);
    // ANMF: size, x, y, width, height (4 + 4 * 3), milliseconds (3); the encoder joins equal frames
    const std::string webp = contentOf(write("a.webp", 25, false));
    const std::size_t shown = find(webp, "ANMF") + 8 + 12;
    EXPECT_EQ(byteAt(webp, shown) + 256 * byteAt(webp, shown + 1), 40u);
}

}  // namespace
