/// Eight floats side by side, and operations on all of them at once: only element-wise + - * / and sqrt.
/// Every lane rounds as a single float does, so the bits are those of a plain loop, whatever instructions are
/// used.
///
/// A file that includes this is compiled once per instruction set; ENGINE_LANES names the copy, so that the
/// linker never mixes them. With AVX2 one register holds all eight floats, otherwise two registers hold four
/// each.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#else
#include <cmath>
#endif

#ifndef ENGINE_LANES
#define ENGINE_LANES baseline
#endif
#define ENGINE_INLINE inline __attribute__((always_inline))

namespace engine::ENGINE_LANES {

inline constexpr int kLanes = 8;
#if defined(__AVX2__)
inline constexpr int kWidth = 8;
#else
inline constexpr int kWidth = 4;
#endif
inline constexpr int kParts = kLanes / kWidth;

using Four = float __attribute__((vector_size(16)));
using Part = float __attribute__((vector_size(4 * kWidth)));
using PartBits = int __attribute__((vector_size(4 * kWidth)));

/// All ones where a comparison holds, otherwise all zeros.
struct Mask {
    PartBits part[kParts];
};

struct Lanes {
    Part part[kParts];

    Lanes() = default;
    ENGINE_INLINE Lanes(float x) {
        for (Part& p : part) p = x - Part{};
    }
    static ENGINE_INLINE Lanes load(const float* x) {
        Lanes a;
        __builtin_memcpy(a.part, x, sizeof a.part);
        return a;
    }
    ENGINE_INLINE void store(float* x) const { __builtin_memcpy(x, part, sizeof part); }
};

#define ENGINE_EACH(R, expression)                         \
    R result;                                              \
    for (int i = 0; i < kParts; ++i) result.part[i] = expression; \
    return result
ENGINE_INLINE Lanes operator+(const Lanes& a, const Lanes& b) { ENGINE_EACH(Lanes, a.part[i] + b.part[i]); }
ENGINE_INLINE Lanes operator-(const Lanes& a, const Lanes& b) { ENGINE_EACH(Lanes, a.part[i] - b.part[i]); }
ENGINE_INLINE Lanes operator*(const Lanes& a, const Lanes& b) { ENGINE_EACH(Lanes, a.part[i] * b.part[i]); }
ENGINE_INLINE Lanes operator/(const Lanes& a, const Lanes& b) { ENGINE_EACH(Lanes, a.part[i] / b.part[i]); }
ENGINE_INLINE Lanes operator-(const Lanes& a) { ENGINE_EACH(Lanes, -a.part[i]); }
ENGINE_INLINE Mask operator<(const Lanes& a, const Lanes& b) { ENGINE_EACH(Mask, a.part[i] < b.part[i]); }
ENGINE_INLINE Mask operator<=(const Lanes& a, const Lanes& b) { ENGINE_EACH(Mask, a.part[i] <= b.part[i]); }
ENGINE_INLINE Mask operator==(const Lanes& a, const Lanes& b) { ENGINE_EACH(Mask, a.part[i] == b.part[i]); }
ENGINE_INLINE Mask operator&(const Mask& a, const Mask& b) { ENGINE_EACH(Mask, a.part[i] & b.part[i]); }
ENGINE_INLINE Mask operator|(const Mask& a, const Mask& b) { ENGINE_EACH(Mask, a.part[i] | b.part[i]); }
ENGINE_INLINE Mask operator^(const Mask& a, const Mask& b) { ENGINE_EACH(Mask, a.part[i] ^ b.part[i]); }
ENGINE_INLINE Mask operator~(const Mask& a) { ENGINE_EACH(Mask, ~a.part[i]); }
/// x where the mask holds, else 0.
ENGINE_INLINE Lanes where(const Mask& m, const Lanes& x) {
    ENGINE_EACH(Lanes, reinterpret_cast<Part>(m.part[i] & reinterpret_cast<PartBits>(x.part[i])));
}
ENGINE_INLINE Lanes absolute(const Lanes& a) {
    ENGINE_EACH(Lanes, reinterpret_cast<Part>(reinterpret_cast<PartBits>(a.part[i]) & 0x7fffffff));
}
ENGINE_INLINE Mask nowhere() { ENGINE_EACH(Mask, PartBits{}); }
/// x where the mask holds, else y.
ENGINE_INLINE Lanes select(const Mask& m, const Lanes& x, const Lanes& y) {
#if defined(__AVX2__)
    ENGINE_EACH(Lanes, _mm256_blendv_ps(y.part[i], x.part[i], reinterpret_cast<Part>(m.part[i])));
#else
    ENGINE_EACH(Lanes, reinterpret_cast<Part>((m.part[i] & reinterpret_cast<PartBits>(x.part[i])) |
                                              (~m.part[i] & reinterpret_cast<PartBits>(y.part[i]))));
#endif
}
/// Returns the second argument where neither is smaller (larger), like the processor's instructions.
#if defined(__AVX2__)
ENGINE_INLINE Lanes smaller(const Lanes& a, const Lanes& b) { ENGINE_EACH(Lanes, _mm256_min_ps(a.part[i], b.part[i])); }
ENGINE_INLINE Lanes larger(const Lanes& a, const Lanes& b) { ENGINE_EACH(Lanes, _mm256_max_ps(a.part[i], b.part[i])); }
#elif defined(__SSE2__)
ENGINE_INLINE Lanes smaller(const Lanes& a, const Lanes& b) { ENGINE_EACH(Lanes, _mm_min_ps(a.part[i], b.part[i])); }
ENGINE_INLINE Lanes larger(const Lanes& a, const Lanes& b) { ENGINE_EACH(Lanes, _mm_max_ps(a.part[i], b.part[i])); }
#else
ENGINE_INLINE Lanes smaller(const Lanes& a, const Lanes& b) { return select(a < b, a, b); }
ENGINE_INLINE Lanes larger(const Lanes& a, const Lanes& b) { return select(b < a, a, b); }
#endif
#undef ENGINE_EACH

ENGINE_INLINE Lanes squareRoot(const Lanes& a) {
    Lanes result;
    for (int i = 0; i < kParts; ++i) {
#if defined(__AVX2__)
        result.part[i] = _mm256_sqrt_ps(a.part[i]);
#elif defined(__SSE2__)
        result.part[i] = _mm_sqrt_ps(a.part[i]);
#else
        for (int k = 0; k < kWidth; ++k) result.part[i][k] = std::sqrt(a.part[i][k]);
#endif
    }
    return result;
}

/// Whether the mask holds in any lane.
ENGINE_INLINE bool any(const Mask& m) {
    bool found = false;
    for (const PartBits& p : m.part) {
#if defined(__AVX2__)
        found = found || _mm256_movemask_ps(reinterpret_cast<Part>(p)) != 0;
#elif defined(__SSE2__)
        found = found || _mm_movemask_ps(reinterpret_cast<Part>(p)) != 0;
#else
        for (int k = 0; k < kWidth; ++k) found = found || p[k] != 0;
#endif
    }
    return found;
}

struct Lanes3 {
    Lanes x, y, z;
};
ENGINE_INLINE Lanes3 operator+(const Lanes3& a, const Lanes3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
ENGINE_INLINE Lanes3 operator-(const Lanes3& a, const Lanes3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
ENGINE_INLINE Lanes3 operator*(const Lanes& s, const Lanes3& a) { return {s * a.x, s * a.y, s * a.z}; }
ENGINE_INLINE Lanes dot(const Lanes3& a, const Lanes3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
ENGINE_INLINE Lanes3 cross(const Lanes3& a, const Lanes3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A symmetric 3 x 3 matrix, stored as its upper triangle.
struct Symmetric3 {
    Lanes xx, xy, xz, yy, yz, zz;
};
ENGINE_INLINE Lanes3 operator*(const Symmetric3& m, const Lanes3& a) {
    return {m.xx * a.x + m.xy * a.y + m.xz * a.z, m.xy * a.x + m.yy * a.y + m.yz * a.z,
            m.xz * a.x + m.yz * a.y + m.zz * a.z};
}

}  // namespace engine::ENGINE_LANES
