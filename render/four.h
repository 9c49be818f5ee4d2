/// Vectors of four numbers, which every x86-64 processor supports; the compilers' vector extensions
/// provide the operators. One of the compilers splits wider vectors into single numbers.
#pragma once
#include <cmath>

namespace render {

inline constexpr int kFour = 4;
using Four = float __attribute__((vector_size(16)));
using FourInts = int __attribute__((vector_size(16)));  // also the result of comparisons: 0 or -1

inline Four fourOf(float v) { return Four{v, v, v, v}; }
inline Four positive(Four v) { return v > 0.0f ? v : Four{}; }
inline Four smaller(Four a, Four b) { return a < b ? a : b; }
inline Four magnitude(Four v) { return v < 0.0f ? -v : v; }
inline Four squareRoot(Four v) {
    for (int i = 0; i < kFour; ++i) v[i] = std::sqrt(v[i]);
    return v;
}

}  // namespace render
