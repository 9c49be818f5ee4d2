#include "engine/collision/gjk.h"

namespace engine {
namespace {

constexpr int kMostSupports = 64;
constexpr double kEpsilon = 1e-13;
constexpr double kFlat = 1e-20;  // sine squared

struct Corner {
    Vec3 onA, onB, p;  // p = onB - onA
    double share = 0.0;
};

/// The points whose weighted sum (by share) is v.
struct Simplex {
    int count = 0;
    std::array<Corner, 4> corner;

    Vec3 nearest() const {
        Vec3 sum = Vec3::Zero();
        for (int i = 0; i < count; ++i) sum += corner[i].share * corner[i].p;
        return sum;
    }
};

/// Weights of up to three corners; 0 for those that do not contribute.
struct Shares {
    std::array<double, 3> of{};
    Vec3 nearest = Vec3::Zero();
};

Shares ofSegment(const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a;
    const double square = ab.squaredNorm();
    const double t = square > 0.0 ? clamped(-a.dot(ab) / square, 0.0, 1.0) : 0.0;
    return {{1.0 - t, t, 0.0}, a + t * ab};
}

/// By the Voronoi regions of the triangle's corners, edges and interior (Ericson 2005, 5.1.5).
Shares ofTriangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a;
    const double d1 = -ab.dot(a), d2 = -ac.dot(a), d3 = -ab.dot(b), d4 = -ac.dot(b),
                 d5 = -ab.dot(c), d6 = -ac.dot(c);
    const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (va > 0.0 && vb > 0.0 && vc > 0.0) {
        const double all = va + vb + vc;
        return {{va / all, vb / all, vc / all}, a + (vb / all) * ab + (vc / all) * ac};
    }
    // Outside: the nearest edge. The same for a degenerate triangle.
    Shares best = ofSegment(a, b);
    const Shares second = ofSegment(b, c), third = ofSegment(a, c);
    if (second.nearest.squaredNorm() < best.nearest.squaredNorm())
        best = {{0.0, second.of[0], second.of[1]}, second.nearest};
    if (third.nearest.squaredNorm() < best.nearest.squaredNorm())
        best = {{third.of[0], 0.0, third.of[1]}, third.nearest};
    return best;
}

/// Keeps the corners that contribute to the nearest point. False: the origin is inside.
bool reduce(Simplex& s) {
    const auto p = [&](int i) -> const Vec3& { return s.corner[i].p; };
    if (s.count == 1) {
        s.corner[0].share = 1.0;
        return true;
    }
    std::array<int, 3> face{0, 1, 2};
    Shares best;
    if (s.count == 2) {
        best = ofSegment(p(0), p(1));
    } else if (s.count == 3) {
        best = ofTriangle(p(0), p(1), p(2));
    } else {
        constexpr int kFaces[4][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
        double least = 1e300;
        bool inside = true;
        for (const auto& f : kFaces) {
            // If inside, the origin is on the fourth corner's side of every face. Four nearly coplanar
            // corners, as polyhedra and rims have them, contain nothing: rounding would decide the sides.
            const Vec3 n = (p(f[1]) - p(f[0])).cross(p(f[2]) - p(f[0])), up = p(f[3]) - p(f[0]);
            const double fourth = n.dot(up);
            const bool flat = fourth * fourth <= kFlat * n.squaredNorm() * up.squaredNorm();
            inside = inside && !flat && -n.dot(p(f[0])) * fourth > 0.0;
            const Shares shares = ofTriangle(p(f[0]), p(f[1]), p(f[2]));
            if (const double d = shares.nearest.squaredNorm(); d < least)
                least = d, best = shares, face = {f[0], f[1], f[2]};
        }
        if (inside) return false;
    }
    Simplex kept;
    for (int i = 0; i < 3 && i < s.count; ++i)
        if (best.of[i] > 0.0) {
            kept.corner[kept.count] = s.corner[face[i]];
            kept.corner[kept.count++].share = best.of[i];
        }
    s = kept;
    return s.count > 0;
}

bool holds(const Simplex& s, const Vec3& p) {
    for (int i = 0; i < s.count; ++i)
        if (s.corner[i].p == p) return true;
    return false;
}

Closest result(const Simplex& s, const Vec3& v) {
    Closest closest;
    closest.onA = closest.onB = Vec3::Zero();
    for (int i = 0; i < s.count; ++i) {
        closest.onA += s.corner[i].share * s.corner[i].onA;
        closest.onB += s.corner[i].share * s.corner[i].onB;
    }
    closest.distance = v.norm();
    if (closest.distance > 0.0) closest.normal = v / closest.distance;
    return closest;
}

}  // namespace

Closest closestPoints(const Convex& a, const Convex& b, const Vec3& shift, double enough) {
    const auto support = [&](const Vec3& d) {
        Corner c;
        c.onA = a.support(-d);
        c.onB = b.support(d) + shift;
        c.p = c.onB - c.onA;
        return c;
    };
    const Vec3 between = b.centre() + shift - a.centre();
    Simplex s;
    s.corner[s.count++] = support(between.squaredNorm() > 0.0 ? Vec3(-between) : Vec3(Vec3::UnitY()));
    s.corner[0].share = 1.0;
    Vec3 v = s.corner[0].p;
    const double touching = 1e-12 * (a.reach() + b.reach() + between.norm());
    for (int i = 0; i < kMostSupports; ++i) {
        const double square = v.squaredNorm();
        if (square <= touching * touching) return {};
        const Corner next = support(-v);
        const double along = v.dot(next.p);  // over |v|: a lower bound of the distance
        if (square - along <= kEpsilon * square || holds(s, next.p)) break;
        if (along > 0.0 && along * along > enough * enough * square) {
            Closest far = result(s, v);
            far.distance = along / std::sqrt(square);
            return far;
        }
        const Simplex before = s;
        s.corner[s.count++] = next;
        if (!reduce(s)) return {};
        const Vec3 nearer = s.nearest();
        if (!(nearer.squaredNorm() < square)) {  // as near as rounding allows
            s = before;
            break;
        }
        v = nearer;
    }
    return result(s, v);
}

}  // namespace engine
