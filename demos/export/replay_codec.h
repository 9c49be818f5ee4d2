/// Numbers of replay.html as 16-bit words, and words as text.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/base/math.h"

namespace demos {

/// Divides a range into 65536 words, with an error of at most 1/131070 of it. An empty range is
/// `low`.
struct WordRange {
    double low = 0.0, size = 0.0;

    std::uint16_t wordOf(double value) const;
    double valueOf(std::uint16_t word) const;
};
/// The smallest range that has all values.
WordRange rangeOf(std::span<const double> values);

/// The 'smallest three' of a unit quaternion: with its largest number made positive, the others lie
/// within +-sqrt(1/2) and take 15 bits each; the top bits of the first two words say which one is
/// left out (x, y, z, w). The error is at most 0.009 degrees.
using RotationWords = std::array<std::uint16_t, 3>;
RotationWords wordsOf(const engine::Quat& rotation);
engine::Quat rotationOf(const RotationWords& words);

/// A unit vector folded onto an octahedron's square, eight bits each way (Cigolle et al. 2014):
/// the error is at most one degree.
std::uint16_t directionWord(const engine::Vec3& direction);
engine::Vec3 directionOf(std::uint16_t word);

/// Columns of `length` words each, as text: every word as its difference from the one before it
/// in its column (steady changes repeat), all low bytes before all high ones, as a zlib stream
/// in base64. `length`: at least 1 where there are words.
std::string textOfColumns(std::span<const std::uint16_t> words, std::size_t length);

}  // namespace demos
