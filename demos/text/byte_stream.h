/// Writes and reads whole numbers and texts as bytes. Small numbers take one byte (LEB128, sign in
/// the lowest bit), so that many of them compress well.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace demos {

class ByteWriter {
public:
    void whole(std::int64_t value);
    void bits32(std::uint32_t value);
    void number(double value);  // all its bits
    void text(const std::string& text);
    const std::vector<std::uint8_t>& bytes() const { return bytes_; }

private:
    std::vector<std::uint8_t> bytes_;
};

/// After the end, or after a value that is not as requested, all values are zero and good() is
/// false.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
    std::int64_t whole();
    /// A whole number from 0 to `most`.
    std::size_t count(std::size_t most);
    std::uint32_t bits32();
    double number();  // finite
    std::string text(std::size_t most);
    bool good() const { return good_; }
    bool atEnd() const { return bytes_.empty(); }
    /// The number of bytes left: no list can be longer.
    std::size_t left() const { return bytes_.size(); }

private:
    std::uint8_t byte();

    std::span<const std::uint8_t> bytes_;
    bool good_ = true;
};

}  // namespace demos
