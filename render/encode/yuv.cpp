// ITU-R BT.709-6, 3.2 to 3.5, with R, G, B in 0..255:
//   Y  =  16 + 219/255 (0.2126 R + 0.7152 G + 0.0722 B)
//   Cb = 128 + 224/255 (B - Y') / 1.8556, Cr = 128 + 224/255 (R - Y') / 1.5748, Y' = 0.2126 R + ...
// The loops are plain, without branches and in 16 bits, so that compilers make lanes of them.
#include "render/encode/yuv.h"

#include <cstddef>

namespace render {
namespace {

using Word = std::uint16_t;

/// A factor in 1/65536.
constexpr Word fixed(double factor) { return static_cast<Word>(factor * 65536.0 + 0.5); }

constexpr double kRed = 0.2126, kGreen = 0.7152, kBlue = 0.0722;
constexpr double kLuma = 219.0 / 255.0, kChroma = 224.0 / 255.0;
constexpr double kForCb = kChroma / 1.8556, kForCr = kChroma / 1.5748;
constexpr Word kRedY = fixed(kLuma * kRed), kGreenY = fixed(kLuma * kGreen);
constexpr Word kBlueY = fixed(kLuma * kBlue);
constexpr Word kRedCb = fixed(kForCb * kRed), kGreenCb = fixed(kForCb * kGreen);
constexpr Word kGreenCr = fixed(kForCr * kGreen), kBlueCr = fixed(kForCr * kBlue);
constexpr Word kHalf = fixed(0.5 * kChroma);  // of blue for Cb, of red for Cr
constexpr Word kRound = 128;                  // half a level: sums are in 1/256

/// The upper half of the product: value * factor / 65536, rounded down.
inline Word times(Word value, Word factor) {
    return static_cast<Word>(std::uint32_t{value} * factor >> 16);
}

/// The colours of a row of pixels, one after the other.
struct Row {
    std::vector<Word> red, green, blue;
    explicit Row(std::size_t width) : red(width), green(width), blue(width) {}
};

void split(const std::uint8_t* pixels, std::size_t width, Row& row) {
    Word* const red = row.red.data();
    Word* const green = row.green.data();
    Word* const blue = row.blue.data();
    for (std::size_t x = 0; x < width; ++x) {
        red[x] = pixels[4 * x];
        green[x] = pixels[4 * x + 1];
        blue[x] = pixels[4 * x + 2];
    }
}

void writeLuma(const Row& row, std::size_t width, std::uint8_t* luma) {
    const Word* const red = row.red.data();
    const Word* const green = row.green.data();
    const Word* const blue = row.blue.data();
    for (std::size_t x = 0; x < width; ++x) {
        const auto sum = static_cast<Word>(
            16 * 256 + kRound + times(static_cast<Word>(red[x] << 8), kRedY) +
            times(static_cast<Word>(green[x] << 8), kGreenY) +
            times(static_cast<Word>(blue[x] << 8), kBlueY));
        luma[x] = static_cast<std::uint8_t>(sum >> 8);
    }
}

/// Of four pixels, times 64: the largest is 4 * 255 * 64 = 65280.
void sumFours(const std::vector<Word>& upper, const std::vector<Word>& lower, std::size_t half,
              std::vector<Word>& sums) {
    const Word *const above = upper.data(), *const below = lower.data();
    Word* const sum = sums.data();
    for (std::size_t x = 0; x < half; ++x)
        sum[x] = static_cast<Word>(
            (above[2 * x] + above[2 * x + 1] + below[2 * x] + below[2 * x + 1]) << 6);
}

/// Half of one colour less shares of the other two.
void writeChroma(const std::vector<Word>& plus, const std::vector<Word>& minus, Word minusFactor,
                 const std::vector<Word>& least, Word leastFactor, std::size_t half,
                 std::uint8_t* chroma) {
    const Word *const a = plus.data(), *const b = minus.data(), *const c = least.data();
    for (std::size_t x = 0; x < half; ++x) {
        const auto sum = static_cast<Word>(128 * 256 + kRound + times(a[x], kHalf) -
                                           times(b[x], minusFactor) - times(c[x], leastFactor));
        chroma[x] = static_cast<std::uint8_t>(sum >> 8);
    }
}

}  // namespace

void toYuv420(const Image& image, std::vector<std::uint8_t>& planes) {
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    const std::size_t all = width * height, half = width / 2;
    planes.resize(all + all / 2);
    std::uint8_t* const luma = planes.data();
    std::uint8_t* const cb = luma + all;
    std::uint8_t* const cr = cb + all / 4;
    Row upper(width), lower(width), fours(half);
    for (std::size_t y = 0; y + 1 < height; y += 2) {
        split(image.pixels.data() + 4 * width * y, width, upper);
        split(image.pixels.data() + 4 * width * (y + 1), width, lower);
        writeLuma(upper, width, luma + width * y);
        writeLuma(lower, width, luma + width * (y + 1));
        sumFours(upper.red, lower.red, half, fours.red);
        sumFours(upper.green, lower.green, half, fours.green);
        sumFours(upper.blue, lower.blue, half, fours.blue);
        writeChroma(fours.blue, fours.green, kGreenCb, fours.red, kRedCb, half,
                    cb + half * (y / 2));
        writeChroma(fours.red, fours.green, kGreenCr, fours.blue, kBlueCr, half,
                    cr + half * (y / 2));
    }
}

}  // namespace render
