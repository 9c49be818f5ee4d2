#include "engine/shapes/face_lanes.h"

namespace engine {

void FaceLanes::add(const Vec3& normal, double offset) {
    const int lane = count_++ % kAtOnce;
    if (lane == 0) blocks_.emplace_back();
    for (int axis = 0; axis < 3; ++axis) blocks_.back()[axis][lane] = normal[axis];
    blocks_.back()[3][lane] = offset;
}

int FaceLanes::lower(const Vec3& p, double radii, double* bounds) const {
    const Pair x{p.x(), p.x()}, y{p.y(), p.y()}, z{p.z(), p.z()}, off{radii, radii};
    Pair largest{-1e300, -1e300};
    double* bound = bounds;
    for (const std::array<Pair, 4>& c : blocks_) {
        const Pair height = c[0] * x + (c[1] * y + c[2] * z) - c[3] - off;
        const Pair before{bound[0], bound[1]}, now = height < before ? height : before;
        bound[0] = now[0], bound[1] = now[1];
        bound += kAtOnce;
        largest = now > largest ? now : largest;
    }
    const double most = larger(largest[0], largest[1]);
    for (int i = 0; i < count_; ++i)
        if (bounds[i] >= most) return i;
    return 0;
}

}  // namespace engine
