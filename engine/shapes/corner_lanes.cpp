#include "engine/shapes/corner_lanes.h"

namespace engine {

CornerLanes::CornerLanes(const std::vector<Vec3>& corners)
    : blocks_((corners.size() + kAtOnce - 1) / kAtOnce) {
    for (std::size_t i = 0; i < kAtOnce * blocks_.size(); ++i) {
        const Vec3& corner = corners[i < corners.size() ? i : 0];
        std::array<Pair, 6>& block = blocks_[i / kAtOnce];
        for (int axis = 0; axis < 3; ++axis)
            block[2 * axis + i % kAtOnce / 2][i % 2] = corner[axis];
    }
}

int CornerLanes::farthest(const Vec3& d) const {
    const Pair x{d.x(), d.x()}, y{d.y(), d.y()}, z{d.z(), d.z()};
    Pair along[kMost / 2];
    const auto largerOf = [](const Pair& a, const Pair& b) { return a > b ? a : b; };
    Pair first{-1e300, -1e300}, second = first;  // the largest so far, of both pairs
    const int blocks = static_cast<int>(blocks_.size());
    for (int i = 0; i < blocks; ++i) {
        const std::array<Pair, 6>& c = blocks_[i];
        along[2 * i] = x * c[0] + (y * c[2] + z * c[4]);
        along[2 * i + 1] = x * c[1] + (y * c[3] + z * c[5]);
        first = largerOf(along[2 * i], first);
        second = largerOf(along[2 * i + 1], second);
    }
    const Pair both = largerOf(first, second);
    const double most = larger(both[0], both[1]);
    for (int i = 0; i < 2 * blocks; i += 2)
        for (int k = 0; k < kAtOnce; ++k)
            if (along[i + k / 2][k % 2] >= most) return 2 * i + k;
    return 0;  // d is not a number
}

}  // namespace engine
