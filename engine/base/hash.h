/// The state hash: equal hashes show that two runs produced the same bits.
/// FNV-1a, 64 bits, over the bytes of each double from the low end, so it is the same on every
/// machine.
#pragma once
#include <bit>
#include <cstdint>

#include "engine/base/math.h"

namespace engine {

class StateHash {
public:
    void add(std::uint64_t bits) {
        for (int byte = 0; byte < 8; ++byte) {
            value_ ^= (bits >> (8 * byte)) & 0xffu;
            value_ *= 0x100000001b3ull;
        }
    }
    /// -0 hashes like +0.
    void add(double x) { add(std::bit_cast<std::uint64_t>(x == 0.0 ? 0.0 : x)); }
    void add(const Vec3& v) { add(v.x()), add(v.y()), add(v.z()); }
    void add(const Quat& q) { add(q.w()), add(q.x()), add(q.y()), add(q.z()); }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

}  // namespace engine
