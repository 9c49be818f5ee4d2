/// The corner of a hull farthest along a direction: the first i with the largest d . c_i.
///
/// The corners' x, y and z lie apart, so that two products are computed side by side. Each is
/// d_x c_x + (d_y c_y + d_z c_z), with the bits of d.dot(c).
#pragma once
#include <array>
#include <vector>

#include "engine/base/math.h"

namespace engine {

class CornerLanes {
public:
    CornerLanes() = default;
    /// Of one or more corners (m), at most `kMost`.
    explicit CornerLanes(const std::vector<Vec3>& corners);

    /// The number of the corner farthest along d (of any length); of several, the first.
    int farthest(const Vec3& d) const;

    static constexpr int kMost = 256;

private:
    using Pair = double __attribute__((vector_size(16)));
    static constexpr int kAtOnce = 4;  // corners

    // Two pairs of x, of y and of z. The last block is filled up with copies of the first corner,
    // which is found before them.
    std::vector<std::array<Pair, 6>> blocks_;
};

}  // namespace engine
