#include "render/encode/png16.h"

#include <libdeflate.h>

#include <memory>
#include <string>
#include <string_view>

#include "render/encode/bytes.h"
#include "render/encode/png.h"
#include "render/error.h"

namespace render {
namespace {

/// Length, name, content, CRC of name and content.
void addChunk(Bytes& file, std::string_view name, std::span<const std::uint8_t> content) {
    addBigEndian32(file, static_cast<std::uint32_t>(content.size()));
    const std::size_t begin = file.size();
    file.insert(file.end(), name.begin(), name.end());
    file.insert(file.end(), content.begin(), content.end());
    addBigEndian32(file, libdeflate_crc32(0, file.data() + begin, file.size() - begin));
}

/// Every row begins with the number of its filter. Sub, the difference of each byte from the same
/// byte of the pixel on the left, turns areas of one colour into zeros.
Bytes filtered(std::span<const std::uint16_t> samples, int height, std::size_t rowSamples,
               std::size_t channels) {
    constexpr std::uint8_t kSub = 1;
    Bytes rows;
    rows.reserve((2 * rowSamples + 1) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        const std::uint16_t* row = samples.data() + rowSamples * static_cast<std::size_t>(y);
        rows.push_back(kSub);
        for (std::size_t i = 0; i < rowSamples; ++i) {
            const unsigned left = i < channels ? 0u : row[i - channels];
            rows.push_back(static_cast<std::uint8_t>((row[i] >> 8) - (left >> 8)));
            rows.push_back(static_cast<std::uint8_t>(row[i] - left));
        }
    }
    return rows;
}

Bytes compressed(const Bytes& bytes) {
    constexpr int kLevel = 1;  // as for pictures (png.cpp)
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(kLevel), &libdeflate_free_compressor);
    if (!compressor) throw Error("out of memory while encoding a PNG; draw smaller pictures");
    Bytes out(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
    out.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), out.data(),
                                        out.size()));
    return out;
}

void checkSize16(std::size_t samples, int width, int height, int channels) {
    const auto allowed = [](int side) { return side >= 1 && side <= kLargestSide; };
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    if (!allowed(width) || !allowed(height) || (channels != 1 && channels != 3))
        throw Error("16-bit picture of " + size + " with " + std::to_string(channels) +
                    " channels: each side must be within 1..16384 pixels, with 1 or 3 channels");
    const std::size_t needed = static_cast<std::size_t>(width) * height * channels;
    if (samples != needed)
        throw Error("a 16-bit picture of " + size + " holds " + std::to_string(samples) +
                    " samples; it needs " + std::to_string(needed));
}

}  // namespace

std::vector<std::uint8_t> encodePng16(std::span<const std::uint16_t> samples, int width,
                                      int height, int channels) {
    checkSize16(samples.size(), width, height, channels);
    constexpr std::uint8_t kDepth = 16, kGrey = 0, kRgb = 2;
    Bytes header;
    addBigEndian32(header, static_cast<std::uint32_t>(width));
    addBigEndian32(header, static_cast<std::uint32_t>(height));
    header.insert(header.end(), {kDepth, channels == 1 ? kGrey : kRgb, 0, 0, 0});
    const std::size_t perPixel = static_cast<std::size_t>(channels);
    Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    addChunk(file, "IHDR", header);
    addChunk(file, "IDAT", compressed(filtered(samples, height, perPixel * width, perPixel)));
    addChunk(file, "IEND", {});
    return file;
}

}  // namespace render
