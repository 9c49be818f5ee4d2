/// As many doubles side by side as one register holds, four or two of eight lanes, as lanes.h has floats: for what is
/// computed once per step from poses. Sums of three are added as Eigen adds them, x + (y + z), so the bits are those of
/// a Vec3.
#pragma once
#include "engine/base/lanes.h"

namespace engine::ENGINE_LANES {

inline constexpr int kDoubles = kWidth / 2;
using DoublePart = double __attribute__((vector_size(8 * kDoubles)));
using DoubleBits = long long __attribute__((vector_size(8 * kDoubles)));
using FloatsOfDoubles = float __attribute__((vector_size(4 * kDoubles)));

struct DoubleMask {
    DoubleBits all;
};

struct Doubles {
    DoublePart all;

    Doubles() = default;
    ENGINE_INLINE Doubles(double x) : all(x - DoublePart{}) {}
    ENGINE_INLINE explicit Doubles(const DoublePart& x) : all(x) {}
    static ENGINE_INLINE Doubles load(const double* x) {
        Doubles a;
        __builtin_memcpy(&a.all, x, sizeof a.all);
        return a;
    }
    /// Rounds to floats.
    ENGINE_INLINE void store(float* x) const {
        const FloatsOfDoubles narrow = __builtin_convertvector(all, FloatsOfDoubles);
        __builtin_memcpy(x, &narrow, sizeof narrow);
    }
};

ENGINE_INLINE Doubles operator+(const Doubles& a, const Doubles& b) { return Doubles(a.all + b.all); }
ENGINE_INLINE Doubles operator-(const Doubles& a, const Doubles& b) { return Doubles(a.all - b.all); }
ENGINE_INLINE Doubles operator*(const Doubles& a, const Doubles& b) { return Doubles(a.all * b.all); }
ENGINE_INLINE Doubles operator/(const Doubles& a, const Doubles& b) { return Doubles(a.all / b.all); }
ENGINE_INLINE DoubleMask operator<(const Doubles& a, const Doubles& b) { return {a.all < b.all}; }
ENGINE_INLINE DoubleMask operator<=(const Doubles& a, const Doubles& b) { return {a.all <= b.all}; }
ENGINE_INLINE DoubleMask operator&(const DoubleMask& a, const DoubleMask& b) { return {a.all & b.all}; }
/// x where the mask holds, else y.
ENGINE_INLINE Doubles select(const DoubleMask& m, const Doubles& x, const Doubles& y) {
#if defined(__AVX2__)
    return Doubles(_mm256_blendv_pd(y.all, x.all, reinterpret_cast<DoublePart>(m.all)));
#else
    return Doubles(reinterpret_cast<DoublePart>((m.all & reinterpret_cast<DoubleBits>(x.all)) |
                                                (~m.all & reinterpret_cast<DoubleBits>(y.all))));
#endif
}
ENGINE_INLINE Doubles absolute(const Doubles& a) {
    return Doubles(reinterpret_cast<DoublePart>(reinterpret_cast<DoubleBits>(a.all) & 0x7fffffffffffffff));
}
/// Like those of base/math.h.
ENGINE_INLINE Doubles smaller(const Doubles& a, const Doubles& b) { return select(a <= b, a, b); }
ENGINE_INLINE Doubles larger(const Doubles& a, const Doubles& b) { return select(b <= a, a, b); }

ENGINE_INLINE Doubles squareRoot(const Doubles& a) {
#if defined(__AVX2__)
    return Doubles(_mm256_sqrt_pd(a.all));
#elif defined(__SSE2__)
    return Doubles(_mm_sqrt_pd(a.all));
#else
    Doubles result;
    for (int k = 0; k < kDoubles; ++k) result.all[k] = std::sqrt(a.all[k]);
    return result;
#endif
}

struct Doubles3 {
    Doubles x, y, z;

    /// From lane `first` on.
    static ENGINE_INLINE Doubles3 load(const double (&v)[3][8], int first) {
        return {Doubles::load(v[0] + first), Doubles::load(v[1] + first), Doubles::load(v[2] + first)};
    }
    ENGINE_INLINE void store(float (&v)[3][8], int first) const {
        x.store(v[0] + first), y.store(v[1] + first), z.store(v[2] + first);
    }
};
ENGINE_INLINE Doubles3 operator+(const Doubles3& a, const Doubles3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
ENGINE_INLINE Doubles3 operator-(const Doubles3& a, const Doubles3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
ENGINE_INLINE Doubles3 operator*(const Doubles& s, const Doubles3& a) { return {s * a.x, s * a.y, s * a.z}; }
ENGINE_INLINE Doubles3 operator/(const Doubles3& a, const Doubles& s) { return {a.x / s, a.y / s, a.z / s}; }
ENGINE_INLINE Doubles dot(const Doubles3& a, const Doubles3& b) { return a.x * b.x + (a.y * b.y + a.z * b.z); }
ENGINE_INLINE Doubles3 cross(const Doubles3& a, const Doubles3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
ENGINE_INLINE Doubles3 select(const DoubleMask& m, const Doubles3& a, const Doubles3& b) {
    return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}

}  // namespace engine::ENGINE_LANES
