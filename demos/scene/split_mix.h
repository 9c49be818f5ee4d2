/// Pseudo-random numbers that are the same on every machine. (The distributions of the standard
/// library differ between implementations.)
#pragma once
#include <cstdint>

namespace demos {

/// Steele, Lea, Flood 2014: 64 bits in, 64 well-mixed bits out.
class SplitMix64 {
public:
    explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    /// In [-1, 1), 53 bits.
    double signedUnit() {
        return static_cast<double>(next() >> 11) * (2.0 / 9007199254740992.0) - 1.0;
    }

private:
    std::uint64_t state_;
};

}  // namespace demos
