/// The bytes of a file in memory.
#pragma once
#include <cstdint>
#include <vector>

namespace render {

using Bytes = std::vector<std::uint8_t>;

inline void addBigEndian32(Bytes& bytes, std::uint32_t value) {
    for (const int shift : {24, 16, 8, 0})
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

inline void addLittleEndian32(Bytes& bytes, std::uint32_t value) {
    for (const int shift : {0, 8, 16, 24})
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

}  // namespace render
