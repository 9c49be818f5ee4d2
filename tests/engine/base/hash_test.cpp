#include "engine/base/hash.h"

#include <gtest/gtest.h>

namespace engine {
namespace {

TEST(StateHash, IsFnv1a) {
    // FNV-1a, 64 bits, of eight zero bytes: offset basis times the prime eight times.
    std::uint64_t expected = 0xcbf29ce484222325ull;
    for (int i = 0; i < 8; ++i) expected *= 0x100000001b3ull;
    StateHash hash;
    hash.add(0.0);
    EXPECT_EQ(hash.value(), expected);
}

TEST(StateHash, MinusZeroIsZero) {
    StateHash plus, minus;
    plus.add(0.0);
    minus.add(-0.0);
    EXPECT_EQ(plus.value(), minus.value());
}

TEST(StateHash, SeesTheLastBitAndTheOrder) {
    StateHash a, b, c;
    a.add(Vec3(1, 2, 3));
    b.add(Vec3(1, 2, 3.0000000000000004));
    c.add(Vec3(2, 1, 3));
    EXPECT_NE(a.value(), b.value());
    EXPECT_NE(a.value(), c.value());
}

}  // namespace
}  // namespace engine
