/// How far a point is above every face of a hull: n_i . p - o_i, two faces side by side, each with the bits of
/// n.dot(p) - o.
#pragma once
#include <array>
#include <vector>

#include "engine/base/math.h"

namespace engine {

class FaceLanes {
public:
    void add(const Vec3& normal, double offset);

    /// Lowers bounds[i] to the height of p above face i, less `radii` (m), where that is less. Returns the first
    /// face with the largest bound. There are as many bounds as faces, up to the next multiple of kAtOnce.
    int lower(const Vec3& p, double radii, double* bounds) const;

    static constexpr int kAtOnce = 2;

private:
    using Pair = double __attribute__((vector_size(16)));

    std::vector<std::array<Pair, 4>> blocks_;  // x, y, z of the normals, offsets
    int count_ = 0;
};

}  // namespace engine
