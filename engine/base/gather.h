/// Loads eight rows of four floats, each at its own address, into lanes, and stores them back: a
/// transposition.
#pragma once
#include "engine/base/lanes.h"

namespace engine::ENGINE_LANES {

ENGINE_INLINE Four loadFour(const float* p) {
    Four f;
    __builtin_memcpy(&f, p, sizeof f);
    return f;
}
ENGINE_INLINE void storeFour(float* p, const Four& f) { __builtin_memcpy(p, &f, sizeof f); }

#if defined(__AVX2__)
/// Rows i and i + 4 in the two halves of one register.
ENGINE_INLINE Part rowsOf(const float* base, int stride, const int* at, int, int i) {
    return __builtin_shufflevector(loadFour(base + stride * at[i]),
                                   loadFour(base + stride * at[i + 4]), 0, 1, 2, 3, 4, 5, 6, 7);
}
ENGINE_INLINE void storeRows(float* base, int stride, const int* at, int, int i, const Part& row) {
    storeFour(base + stride * at[i], __builtin_shufflevector(row, row, 0, 1, 2, 3));
    storeFour(base + stride * at[i + 4], __builtin_shufflevector(row, row, 4, 5, 6, 7));
}
#define ENGINE_INTERLEAVE(a, b, i, j, k, l) \
    __builtin_shufflevector(a, b, i, 8 + (j), k, 8 + (l), 4 + (i), 12 + (j), 4 + (k), 12 + (l))
#define ENGINE_JOIN(a, b, i, j) \
    __builtin_shufflevector(a, b, i, j, 8 + (i), 8 + (j), 4 + (i), 4 + (j), 12 + (i), 12 + (j))
#else
ENGINE_INLINE Part rowsOf(const float* base, int stride, const int* at, int part, int i) {
    return loadFour(base + stride * at[4 * part + i]);
}
ENGINE_INLINE void storeRows(float* base, int stride, const int* at, int part, int i,
                             const Part& row) {
    storeFour(base + stride * at[4 * part + i], row);
}
#define ENGINE_INTERLEAVE(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, 4 + (j), k, 4 + (l))
#define ENGINE_JOIN(a, b, i, j) __builtin_shufflevector(a, b, i, j, 4 + (i), 4 + (j))
#endif

/// x, y, z of the rows base + stride * at[0..7].
ENGINE_INLINE Lanes3 gather(const float* base, int stride, const int* at) {
    Lanes3 v;
    for (int p = 0; p < kParts; ++p) {
        const Part a = rowsOf(base, stride, at, p, 0), b = rowsOf(base, stride, at, p, 1);
        const Part c = rowsOf(base, stride, at, p, 2), d = rowsOf(base, stride, at, p, 3);
        const Part xyAB = ENGINE_INTERLEAVE(a, b, 0, 0, 1, 1);  // xa xb ya yb
        const Part xyCD = ENGINE_INTERLEAVE(c, d, 0, 0, 1, 1);
        const Part zAB = ENGINE_INTERLEAVE(a, b, 2, 2, 3, 3);
        const Part zCD = ENGINE_INTERLEAVE(c, d, 2, 2, 3, 3);
        v.x.part[p] = ENGINE_JOIN(xyAB, xyCD, 0, 1);
        v.y.part[p] = ENGINE_JOIN(xyAB, xyCD, 2, 3);
        v.z.part[p] = ENGINE_JOIN(zAB, zCD, 0, 1);
    }
    return v;
}

/// The inverse of gather; the fourth float of every row becomes 0.
ENGINE_INLINE void scatter(const Lanes3& v, float* base, int stride, const int* at) {
    const Part zero = Part{};
    for (int p = 0; p < kParts; ++p) {
        const Part xyAB = ENGINE_INTERLEAVE(v.x.part[p], v.y.part[p], 0, 0, 1, 1);  // xa ya xb yb
        const Part xyCD = ENGINE_INTERLEAVE(v.x.part[p], v.y.part[p], 2, 2, 3, 3);
        const Part zAB = ENGINE_INTERLEAVE(v.z.part[p], zero, 0, 0, 1, 1);
        const Part zCD = ENGINE_INTERLEAVE(v.z.part[p], zero, 2, 2, 3, 3);
        storeRows(base, stride, at, p, 0, ENGINE_JOIN(xyAB, zAB, 0, 1));
        storeRows(base, stride, at, p, 1, ENGINE_JOIN(xyAB, zAB, 2, 3));
        storeRows(base, stride, at, p, 2, ENGINE_JOIN(xyCD, zCD, 0, 1));
        storeRows(base, stride, at, p, 3, ENGINE_JOIN(xyCD, zCD, 2, 3));
    }
}
#undef ENGINE_INTERLEAVE
#undef ENGINE_JOIN

}  // namespace engine::ENGINE_LANES
