/// FNV-1a, 64 bits, of texts and files. For the state of a world use engine::StateHash.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

namespace demos {

class TextHash {
public:
    void add(std::span<const std::uint8_t> bytes) {
        addPiece(bytes);
        endPieces();
    }
    /// The same in pieces.
    void addPiece(std::span<const std::uint8_t> bytes) {
        for (const std::uint8_t byte : bytes) mix(byte);
    }
    void endPieces() { mix(0xff); }  // so that "ab" "c" and "a" "bc" differ: no UTF-8 text contains this byte
    void add(std::string_view text) {
        for (const char c : text) mix(static_cast<std::uint8_t>(c));
        mix(0xff);
    }
    std::uint64_t value() const { return value_; }

private:
    void mix(std::uint8_t byte) {
        value_ ^= byte;
        value_ *= 0x100000001b3ull;
    }
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

/// The hash of one file or text.
inline std::uint64_t hashOf(std::span<const std::uint8_t> bytes) {
    TextHash hash;
    hash.add(bytes);
    return hash.value();
}
inline std::uint64_t hashOf(std::string_view text) {
    TextHash hash;
    hash.add(text);
    return hash.value();
}

}  // namespace demos
