#include "engine/collision/way_out.h"

namespace engine {
namespace {

constexpr double kClear = 1e-5;  // of the pieces' size: closer, GJK's normal loses digits
constexpr double kGap = 1e-2;    // of the pieces' size: how far they are moved apart to find one
constexpr int kMostPushes = 24;
constexpr int kMostTurns = 8;

/// The normal where b, pushed along d, separates from a. Starting too far out, the push is reduced
/// by what the closest points allow: along their normal, that distance is certainly free.
Closest pushOut(const Convex& a, const Convex& b, const Vec3& d, double gap) {
    double push = gap - separationOfCores(a, b, d);
    Closest closest = closestPoints(a, b, push * d);
    for (int i = 0; i < kMostPushes; ++i) {
        const double along = closest.normal.dot(d);
        if (closest.distance < 1.05 * gap || along < 1e-6) break;
        const double nearer = push - (closest.distance - gap) / along;
        if (nearer <= 0.0) break;  // they overlap there: d is nearly along a face
        push = nearer;
        closest = closestPoints(a, b, push * d);
    }
    return closest;
}

Vec3 fromAToB(const Convex& a, const Convex& b) {
    if (a.isTriangle()) return a.front();
    if (b.isTriangle()) return -b.front();
    const Vec3 between = b.centre() - a.centre();
    const double length = between.norm();
    return length > 0.0 ? Vec3(between / length) : Vec3(Vec3::UnitY());
}

}  // namespace

WayOut wayOut(const Convex& a, const Convex& b, double enough) {
    const double size = a.reach() + b.reach(), gap = kGap * size;
    const Closest apart = closestPoints(a, b, Vec3::Zero(), enough);
    if (apart.distance > kClear * size)
        return {apart.normal, apart.distance, apart.onA, apart.onB};
    const Vec3 d = fromAToB(a, b);
    if (size <= 0.0) return {d, 0.0, a.centre(), b.centre()};
    Vec3 n = pushOut(a, b, d, gap).normal;
    if (n.isZero(0.0)) n = d;
    WayOut best{n, -1e300, a.centre(), b.centre()};
    for (int i = 0; i < kMostTurns; ++i) {
        const double separation = separationOfCores(a, b, n);
        if (separation <= best.separation + 1e-9 * size) break;
        const Vec3 push = (gap - separation) * n;
        const Closest closest = closestPoints(a, b, push);
        if (closest.normal.isZero(0.0)) {  // GJK sees no gap: an outermost point along n
            const Vec3 onA = a.support(n);
            best = {n, separation, onA, onA + separation * n};
            break;
        }
        best = {n, separation, closest.onA, closest.onB - push};
        n = closest.normal;
    }
    return best;
}

}  // namespace engine
