/// The chunks that a PNG file consists of. PNG 1.2, section 3.2.
#pragma once
#include <libdeflate.h>

#include <span>
#include <string_view>

#include "render/encode/bytes.h"

namespace render {

inline constexpr std::uint8_t kPngSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

/// Appends length, name, content, CRC of name and content.
inline void addChunk(Bytes& file, std::string_view name, std::span<const std::uint8_t> content) {
    addBigEndian32(file, static_cast<std::uint32_t>(content.size()));
    const std::size_t begin = file.size();
    file.insert(file.end(), name.begin(), name.end());
    file.insert(file.end(), content.begin(), content.end());
    addBigEndian32(file, libdeflate_crc32(0, file.data() + begin, file.size() - begin));
}

/// Appends size, bits of a sample and kind of pixel; neither interlaced nor of another method.
inline void addPngHeader(Bytes& file, int width, int height, std::uint8_t bits,
                         std::uint8_t kind) {
    Bytes header;
    header.reserve(13);
    addBigEndian32(header, static_cast<std::uint32_t>(width));
    addBigEndian32(header, static_cast<std::uint32_t>(height));
    for (const std::uint8_t byte : {bits, kind, std::uint8_t{0}, std::uint8_t{0}, std::uint8_t{0}})
        header.push_back(byte);
    addChunk(file, "IHDR", header);
}

}  // namespace render
