#include "render/encode/png.h"

#include <libdeflate.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>

#include "render/encode/png_chunks.h"
#include "render/error.h"

namespace render {
namespace {

/// Kept for the next picture: the compressor is a megabyte that would have to be cleared every
/// time, and new pages for the buffers cost more than what is written to them.
struct PngDesk {
    std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor{
        libdeflate_alloc_compressor(1), &libdeflate_free_compressor};  // fast, and small enough
    Bytes rows;
    std::unique_ptr<std::uint8_t[]> compressed;  // pages that are not written to take no memory
    std::size_t room = 0;                        // bytes of `compressed`
};
constexpr std::size_t kMostBytesKept = 16u << 20;  // bytes of rows: more would add to a film's memory

PngDesk& keptDesk() {
    thread_local PngDesk desk;
    if (!desk.compressor)
        throw Error("out of memory while encoding a PNG; draw smaller pictures");
    return desk;
}

/// Without an early exit, so that the compiler can vectorise the loop.
bool isOpaque(const Image& image) {
    std::uint8_t all = 255;
    for (std::size_t alpha = 3; alpha < image.pixels.size(); alpha += 4) all &= image.pixels[alpha];
    return all == 255;
}

/// Without alpha, four bytes are copied at a time: the next pixel overwrites the fourth, the last
/// one's is where the next row begins, or beyond the last row.
void copyRow(const std::uint8_t* from, int width, bool opaque, std::uint8_t* to) {
    const auto count = static_cast<std::size_t>(width);
    if (!opaque) {
        std::memcpy(to, from, 4 * count);
        return;
    }
    for (std::size_t i = 0; i < count; ++i) std::memcpy(to + 3 * i, from + 4 * i, 4);
}

/// The rows of a picture; each begins with the number of its filter. Returns their size: `rows` may
/// be larger.
std::size_t fillRows(const Image& image, bool opaque, Bytes& rows) {
    constexpr std::uint8_t kNone = 0;
    const std::size_t width = static_cast<std::size_t>(image.width);
    const std::size_t stride = 1 + (opaque ? 3 : 4) * width;
    const std::size_t size = stride * static_cast<std::size_t>(image.height);
    if (rows.size() < size + 1) rows.resize(size + 1);
    for (int y = 0; y < image.height; ++y) {
        std::uint8_t* const row = &rows[stride * static_cast<std::size_t>(y)];
        row[0] = kNone;
        copyRow(&image.pixels[4 * width * static_cast<std::size_t>(y)], image.width, opaque,
                row + 1);
    }
    return size;
}

std::span<const std::uint8_t> compressed(PngDesk& desk, std::size_t size) {
    const std::size_t room = libdeflate_zlib_compress_bound(desk.compressor.get(), size);
    if (desk.room < room) {
        desk.compressed.reset(new std::uint8_t[room]);
        desk.room = room;
    }
    const std::size_t used = libdeflate_zlib_compress(
        desk.compressor.get(), desk.rows.data(), size, desk.compressed.get(), room);
    return {desk.compressed.get(), used};
}

/// Pixels per metre in both directions: PNG 1.2, section 4.2.4.2.
void addPhysicalSize(Bytes& file, int dpi) {
    const auto perMeter = static_cast<std::uint32_t>(std::lround(dpi / 0.0254));
    Bytes content;
    content.reserve(9);  // all of it: otherwise GCC 12 warns of an overflow that cannot happen
    addBigEndian32(content, perMeter);
    addBigEndian32(content, perMeter);
    content.push_back(1);  // the unit: a metre
    addChunk(file, "pHYs", content);
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
    if (bytes.size() < 33 || !std::equal(kPngSignature, kPngSignature + 8, bytes.begin()))
        return false;
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
    constexpr std::uint8_t kRgb = 2, kRgba = 6;
    const bool opaque = isOpaque(image);
    PngDesk& desk = keptDesk();
    const std::size_t size = fillRows(image, opaque, desk.rows);
    const std::span<const std::uint8_t> content = compressed(desk, size);
    Bytes file;
    file.reserve(content.size() + 100);
    file.insert(file.end(), std::begin(kPngSignature), std::end(kPngSignature));
    addPngHeader(file, image.width, image.height, 8, opaque ? kRgb : kRgba);
    if (dpi > 0) addPhysicalSize(file, dpi);
    addChunk(file, "IDAT", content);
    addChunk(file, "IEND", {});
    if (size > kMostBytesKept) {
        desk.rows = {};
        desk.compressed.reset();
        desk.room = 0;
    }
    return file;
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
