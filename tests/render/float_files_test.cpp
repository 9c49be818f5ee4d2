// The bytes of the data passes' files, against their formats' definitions.
#include <gtest/gtest.h>
#include <libdeflate.h>

#include <cstring>
#include <string>

#include "render/encode/float_files.h"
#include "render/encode/png.h"
#include "render/encode/png16.h"
#include "render/encode/png_read.h"
#include "render/error.h"

namespace render {
namespace {

using Bytes = std::vector<std::uint8_t>;

float floatAt(const Bytes& bytes, std::size_t at) {
    float value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

TEST(Pfm, HeaderThenRowsFromTheBottom) {
    const std::vector<float> values = {1, 2, 3, 4, 5, 6.5f};
    const Bytes file = encodePfm(values, 3, 2);
    const std::string header = "Pf\n3 2\n-1.0\n";
    ASSERT_EQ(file.size(), header.size() + 24);
    EXPECT_EQ(std::string(file.begin(), file.begin() + 12), header);
    EXPECT_EQ(floatAt(file, 12), 4.0f);
    EXPECT_EQ(floatAt(file, 12 + 8), 6.5f);
    EXPECT_EQ(floatAt(file, 12 + 12), 1.0f);
}

TEST(Flo, MagicSizeThenPairsFromTheTop) {
    const std::vector<Eigen::Vector2f> flow = {{1, -2}, {3, 4}};
    const Bytes file = encodeFlo(flow, 2, 1);
    ASSERT_EQ(file.size(), 12u + 16u);
    EXPECT_EQ(floatAt(file, 0), 202021.25f);
    EXPECT_EQ(file[4], 2);
    EXPECT_EQ(file[8], 1);
    EXPECT_EQ(floatAt(file, 12), 1.0f);
    EXPECT_EQ(floatAt(file, 16), -2.0f);
    EXPECT_EQ(floatAt(file, 24), 4.0f);
}

TEST(FloatFiles, RefuseAWrongNumberOfPixels) {
    EXPECT_THROW(encodePfm(std::vector<float>(5), 3, 2), Error);
    EXPECT_THROW(encodeFlo(std::vector<Eigen::Vector2f>(5), 3, 2), Error);
    EXPECT_THROW(encodePng16(std::vector<std::uint16_t>(5), 3, 2, 1), Error);
    EXPECT_THROW(encodePng16(std::vector<std::uint16_t>(12), 3, 2, 2), Error);
    EXPECT_THROW(encodePng16({}, 0, 2, 1), Error);
}

/// Decodes a PNG as encodePng16 writes it: one IDAT, filter Sub.
std::vector<std::uint16_t> samplesOf(const Bytes& png, int width, int height, int channels) {
    const std::size_t length = std::size_t{png[33]} << 24 | std::size_t{png[34]} << 16 |
                               std::size_t{png[35]} << 8 | png[36];
    const std::size_t row = 2u * static_cast<std::size_t>(width) * channels + 1;
    Bytes raw(row * height);
    libdeflate_decompressor* d = libdeflate_alloc_decompressor();
    EXPECT_EQ(libdeflate_zlib_decompress(d, png.data() + 41, length, raw.data(), raw.size(),
                                         nullptr),
              LIBDEFLATE_SUCCESS);
    libdeflate_free_decompressor(d);
    std::vector<std::uint16_t> samples;
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        EXPECT_EQ(raw[y * row], 1);
        Bytes line(raw.begin() + static_cast<long>(y * row + 1),
                   raw.begin() + static_cast<long>((y + 1) * row));
        const std::size_t back = 2u * channels;
        for (std::size_t i = back; i < line.size(); ++i)
            line[i] = static_cast<std::uint8_t>(line[i] + line[i - back]);
        for (std::size_t i = 0; i < line.size(); i += 2)
            samples.push_back(static_cast<std::uint16_t>(line[i] << 8 | line[i + 1]));
    }
    return samples;
}

TEST(Png16, KeepsEverySample) {
    for (const int channels : {1, 3}) {
        std::vector<std::uint16_t> samples;
        for (int i = 0; i < 7 * 5 * channels; ++i)
            samples.push_back(static_cast<std::uint16_t>(i * 40503 % 65536));
        const Bytes png = encodePng16(samples, 7, 5, channels);
        EXPECT_TRUE(pngIsWhole(png, 7, 5));
        EXPECT_EQ(png[24], 16);                     // bits
        EXPECT_EQ(png[25], channels == 1 ? 0 : 2);  // grey or RGB
        EXPECT_EQ(samplesOf(png, 7, 5, channels), samples);
    }
}

TEST(Png16, IsReadByOthersToo) {
    const std::vector<std::uint16_t> samples = {0x1234, 0xffff, 0, 0xab00};
    const Image image = decodePng(encodePng16(samples, 2, 2, 1));  // stb's upper bytes
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(image.pixels[4 * static_cast<std::size_t>(i)],
                  samples[static_cast<std::size_t>(i)] >> 8);
}

}  // namespace
}  // namespace render
