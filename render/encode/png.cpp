#include "render/encode/png.h"

#include <libdeflate.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include "render/encode/bytes.h"
#include "render/error.h"

namespace {

/// Kept for the next picture: it is a megabyte that would have to be cleared every time.
libdeflate_compressor* keptCompressor() {
    thread_local const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)>
        kept(libdeflate_alloc_compressor(1), &libdeflate_free_compressor);
    return kept.get();
}

/// Replaces stb's compressor: level 1 of libdeflate is faster and compresses better.
/// The buffer comes from malloc because stb frees it.
unsigned char* deflateFast(unsigned char* bytes, int size, int* compressedSize, int /*quality*/) {
    libdeflate_compressor* const compressor = keptCompressor();
    if (!compressor) return nullptr;
    const auto length = static_cast<std::size_t>(size);
    const std::size_t room = libdeflate_zlib_compress_bound(compressor, length);
    auto* out = static_cast<unsigned char*>(std::malloc(room));
    if (!out) return nullptr;
    const auto used = libdeflate_zlib_compress(compressor, bytes, length, out, room);
    *compressedSize = static_cast<int>(used);  // fits: 4 * 16384^2 = 2^30
    return out;
}

/// Replaces stb's own, which goes byte by byte.
unsigned int crc32(const unsigned char* bytes, int size) {
    return libdeflate_crc32(0, bytes, static_cast<std::size_t>(size));
}

}  // namespace

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wconversion"
#endif
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS deflateFast
#define STBIW_CRC32 crc32
#include <stb/stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace render {
namespace {

/// Without an early exit, so that the compiler can vectorise the loop.
bool isOpaque(const Image& image) {
    std::uint8_t all = 255;
    for (std::size_t alpha = 3; alpha < image.pixels.size(); alpha += 4) all &= image.pixels[alpha];
    return all == 255;
}

/// Copies four bytes at a time: the next pixel overwrites the fourth.
Bytes withoutAlpha(const Image& image) {
    const std::size_t count = image.pixels.size() / 4;
    Bytes rgb(3 * count + 1);
    for (std::size_t i = 0; i < count; ++i)
        std::memcpy(&rgb[3 * i], &image.pixels[4 * i], 4);
    rgb.pop_back();
    return rgb;
}

/// Pixels per metre in both directions: PNG 1.2, section 4.2.4.2.
Bytes physicalSize(int dpi) {
    const auto perMeter = static_cast<std::uint32_t>(std::lround(dpi / 0.0254));
    Bytes chunk;
    chunk.reserve(21);  // all of it: otherwise GCC 12 warns of an overflow that cannot happen
    addBigEndian32(chunk, 9);
    chunk.insert(chunk.end(), {'p', 'H', 'Y', 's'});
    addBigEndian32(chunk, perMeter);
    addBigEndian32(chunk, perMeter);
    chunk.push_back(1);  // the unit: a metre
    addBigEndian32(chunk, libdeflate_crc32(0, chunk.data() + 4, chunk.size() - 4));
    return chunk;
}

std::uint32_t bigEndian32(std::span<const std::uint8_t> bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | bytes[at + i];
    return value;
}

bool hasName(std::span<const std::uint8_t> bytes, std::size_t at, const char* name) {
    return std::memcmp(bytes.data() + at, name, 4) == 0;
}

/// One chunk: length (4), name (4), content, CRC of name and content (4). PNG 1.2, section 3.2.
struct Chunk {
    std::size_t name = 0, next = 0;  // offsets in the file; next = 0: damaged
};

Chunk chunkAt(std::span<const std::uint8_t> bytes, std::size_t at) {
    if (bytes.size() - at < 12) return {};
    const std::size_t length = bigEndian32(bytes, at);
    if (length > bytes.size() - at - 12) return {};
    const std::uint32_t crc = libdeflate_crc32(0, bytes.data() + at + 4, length + 4);
    if (crc != bigEndian32(bytes, at + 8 + length)) return {};
    return {at + 4, at + 12 + length};
}

bool startsWithHeader(std::span<const std::uint8_t> bytes, int width, int height) {
    constexpr std::uint8_t kSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    if (bytes.size() < 33 || !std::equal(kSignature, kSignature + 8, bytes.begin())) return false;
    return bigEndian32(bytes, 8) == 13 && hasName(bytes, 12, "IHDR") &&
           bigEndian32(bytes, 16) == static_cast<std::uint32_t>(width) &&
           bigEndian32(bytes, 20) == static_cast<std::uint32_t>(height);
}

}  // namespace

void checkSize(const Image& image) {
    const auto allowed = [](int side) { return side >= 1 && side <= kLargestSide; };
    const std::string size = std::to_string(image.width) + "x" + std::to_string(image.height);
    if (!allowed(image.width) || !allowed(image.height)) {
        throw Error("picture size " + size + ": each side must be within 1.." +
                    std::to_string(kLargestSide) + " pixels");
    }
    const std::size_t needed = std::size_t{4} * image.width * image.height;
    if (image.pixels.size() != needed) {
        throw Error("a picture of " + size + " holds " + std::to_string(image.pixels.size()) +
                    " bytes; RGBA needs " + std::to_string(needed));
    }
}

std::vector<std::uint8_t> encodePng(const Image& image, int dpi) {
    checkSize(image);
    static const int noFilter = stbi_write_force_png_filter = 0;  // once: it is global in stb
    static_cast<void>(noFilter);
    const bool opaque = isOpaque(image);
    const int channels = opaque ? 3 : 4;
    const Bytes rgb = opaque ? withoutAlpha(image) : Bytes{};
    const std::uint8_t* pixels = opaque ? rgb.data() : image.pixels.data();
    int size = 0;
    const std::unique_ptr<unsigned char, decltype(&std::free)> png(
        stbi_write_png_to_mem(pixels, 0, image.width, image.height, channels, &size), &std::free);
    if (!png) throw Error("out of memory while encoding a PNG; draw smaller pictures");
    constexpr int kHeaderEnd = 33;  // signature and IHDR, after which pHYs is allowed
    if (dpi <= 0) return {png.get(), png.get() + size};
    Bytes bytes(png.get(), png.get() + kHeaderEnd);
    const Bytes chunk = physicalSize(dpi);
    bytes.insert(bytes.end(), chunk.begin(), chunk.end());
    bytes.insert(bytes.end(), png.get() + kHeaderEnd, png.get() + size);
    return bytes;
}

bool pngIsWhole(std::span<const std::uint8_t> bytes, int width, int height) {
    if (!startsWithHeader(bytes, width, height)) return false;
    bool hasPixels = false;
    for (std::size_t at = 8; at < bytes.size();) {
        const Chunk chunk = chunkAt(bytes, at);
        if (chunk.next == 0) return false;
        if (hasName(bytes, chunk.name, "IEND")) return hasPixels && chunk.next == bytes.size();
        hasPixels = hasPixels || hasName(bytes, chunk.name, "IDAT");
        at = chunk.next;
    }
    return false;
}

}  // namespace render
