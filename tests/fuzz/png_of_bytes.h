// PNG files of arbitrary bytes, with the checksums that a decoder asks for first.
#pragma once
#include <libdeflate.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "demos/text/deflate.h"

namespace fuzz {

using PngBytes = std::vector<std::uint8_t>;

inline constexpr std::size_t kSignature = 8;  // bytes
inline constexpr std::size_t kIhdr = 13;

inline std::uint32_t bigEndianAt(std::span<const std::uint8_t> bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | bytes[at + i];
    return value;
}

inline void putBigEndian(PngBytes& bytes, std::uint32_t value) {
    for (const int shift : {24, 16, 8, 0})
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// Width and height as the file claims them; 0, 0 if it is too short.
inline std::pair<int, int> sizeOfPng(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < kSignature + 8 + kIhdr) return {0, 0};
    const auto side = [&](std::size_t at) {
        return static_cast<int>(std::min(bigEndianAt(bytes, at), 0x7fffffffu));
    };
    return {side(kSignature + 8), side(kSignature + 12)};
}

/// The file with the right checksum at the end of every chunk.
inline PngBytes withChecksums(std::span<const std::uint8_t> file) {
    PngBytes bytes(file.begin(), file.end());
    for (std::size_t at = kSignature; at + 12 <= bytes.size();) {
        const std::size_t length = bigEndianAt(bytes, at);
        if (length > bytes.size() - at - 12) break;
        const std::uint32_t sum = libdeflate_crc32(0, bytes.data() + at + 4, length + 4);
        for (std::size_t i = 0; i < 4; ++i)
            bytes[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
        at += 12 + length;
    }
    return bytes;
}

/// A file whose IHDR are the first bytes and whose rows, compressed, are the others.
inline PngBytes pngOfRows(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < kIhdr) return {};
    PngBytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    const auto add = [&file](std::string_view type, std::span<const std::uint8_t> content) {
        putBigEndian(file, static_cast<std::uint32_t>(content.size()));
        file.insert(file.end(), type.begin(), type.end());
        file.insert(file.end(), content.begin(), content.end());
        putBigEndian(file, 0);
    };
    add("IHDR", bytes.first(kIhdr));
    add("IDAT", demos::deflated(bytes.subspan(kIhdr)));
    add("IEND", {});
    return withChecksums(file);
}

}  // namespace fuzz
