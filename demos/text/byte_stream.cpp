#include "demos/text/byte_stream.h"

#include <bit>
#include <cmath>

#include "demos/text/little_endian.h"

namespace demos {

void ByteWriter::whole(std::int64_t value) {
    std::uint64_t bits = static_cast<std::uint64_t>(value) << 1 ^
                         static_cast<std::uint64_t>(value < 0 ? -1 : 0);
    for (; bits >= 128; bits >>= 7) bytes_.push_back(static_cast<std::uint8_t>(bits | 128u));
    bytes_.push_back(static_cast<std::uint8_t>(bits));
}

void ByteWriter::bits32(std::uint32_t value) { putBytes(bytes_, value); }

void ByteWriter::number(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    bits32(static_cast<std::uint32_t>(bits));
    bits32(static_cast<std::uint32_t>(bits >> 32));
}

void ByteWriter::text(const std::string& text) {
    whole(static_cast<std::int64_t>(text.size()));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
}

std::uint8_t ByteReader::byte() {
    if (bytes_.empty()) good_ = false;
    if (!good_) return 0;
    const std::uint8_t value = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return value;
}

std::int64_t ByteReader::whole() {
    std::uint64_t bits = 0;
    for (int shift = 0; shift < 64; shift += 7) {
        const std::uint8_t value = byte();
        bits |= static_cast<std::uint64_t>(value & 127u) << shift;
        if (value < 128)
            return static_cast<std::int64_t>(bits >> 1 ^ (bits & 1 ? ~std::uint64_t{0} : 0));
    }
    good_ = false;
    return 0;
}

std::size_t ByteReader::count(std::size_t most) {
    const std::int64_t value = whole();
    if (value < 0 || static_cast<std::uint64_t>(value) > most) good_ = false;
    return good_ ? static_cast<std::size_t>(value) : 0;
}

std::uint32_t ByteReader::bits32() {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(byte()) << 8 * i;
    return value;
}

double ByteReader::number() {
    const std::uint64_t low = bits32(), high = bits32();
    const auto value = std::bit_cast<double>(high << 32 | low);
    if (!std::isfinite(value)) good_ = false;
    return good_ ? value : 0.0;
}

std::string ByteReader::text(std::size_t most) {
    std::size_t size = count(most);
    if (size > left()) good_ = false, size = 0;
    const std::string text(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(size));
    bytes_ = bytes_.subspan(size);
    return text;
}

}  // namespace demos
