/// The normal and separation of two convex pieces, separate or overlapping.
#pragma once
#include "engine/collision/gjk.h"

namespace engine {

struct WayOut {
    Vec3 normal = Vec3::UnitY();  // unit, from a to b
    double separation = 0.0;      // m, of the cores along it; negative: they overlap
    Vec3 onA, onB;                // m, where they touch when moved apart along the normal
};

/// If they are certainly farther apart than `enough` (m), the separation is only a lower bound.
WayOut wayOut(const Convex& a, const Convex& b, double enough = kFar);

/// n.(s_B(-n) - s_A(n)), m, of the cores.
inline double separationOfCores(const Convex& a, const Convex& b, const Vec3& n) {
    return n.dot(b.support(-n) - a.support(n));
}

}  // namespace engine
