/// Numbers as bytes, lowest byte first.
#pragma once
#include <cstdint>
#include <vector>

namespace demos {

/// `size`: how many of the four bytes of `value`.
inline void putBytes(std::vector<std::uint8_t>& out, std::uint32_t value, int size = 4) {
    for (int i = 0; i < size; ++i) out.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

}  // namespace demos
