#include "engine/collision/gjk.h"

namespace engine {
namespace {

constexpr int kMostSupports = 64;
constexpr double kEpsilon = 1e-13;
constexpr double kFlat = 1e-20;  // sine squared

struct Corner {
    Vec3 onA, onB, p;  // p = onB - onA
};

/// Weights of up to three corners; 0 for those that do not contribute.
struct Shares {
    std::array<double, 3> of{};
    Vec3 nearest = Vec3::Zero();
};

/// `along`: -a . (b - a).
Shares ofSegment(const Vec3& a, const Vec3& ab, double along) {
    const double square = ab.squaredNorm();
    const double t = square > 0.0 ? clamped(along / square, 0.0, 1.0) : 0.0;
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
    const Vec3 bc = c - b;
    Shares best = ofSegment(a, ab, d1);
    const Shares second = ofSegment(b, bc, -b.dot(bc)), third = ofSegment(a, ac, d2);
    if (second.nearest.squaredNorm() < best.nearest.squaredNorm())
        best = {{0.0, second.of[0], second.of[1]}, second.nearest};
    if (third.nearest.squaredNorm() < best.nearest.squaredNorm())
        best = {{third.of[0], 0.0, third.of[1]}, third.nearest};
    return best;
}

/// Up to four points; their weighted sum v is the one nearest to the origin.
class Simplex {
public:
    explicit Simplex(const Corner& first) : v_(first.p) { corners_[0] = first; }

    const Vec3& nearest() const { return v_; }
    bool holds(const Vec3& p) const {
        for (int i = 0; i < count_; ++i)
            if (corners_[i].p == p) return true;
        return false;
    }
    enum class Step { nearer, done, inside };
    /// Adds a corner and omits those that do not contribute to the new nearest point. Done: it is as near as
    /// rounding allows, and nothing changes. Inside: the origin is. `isOutside`: it is known to be outside, which
    /// rounding might decide otherwise where the corners are nearly coplanar.
    Step add(const Corner& next, bool isOutside);
    Closest result() const;

private:
    const Vec3& p(int i) const { return corners_[i].p; }
    /// The face of the tetrahedron nearest to the origin. False: the origin is inside.
    bool nearestFace(std::array<int, 3>& face, Shares& best, bool isOutside) const;

    int count_ = 1;
    std::array<Corner, 4> corners_;
    Shares shares_{{1.0, 0.0, 0.0}, Vec3::Zero()};
    Vec3 v_;
};

bool Simplex::nearestFace(std::array<int, 3>& face, Shares& best, bool isOutside) const {
    constexpr int kFaces[4][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
    double least = 1e300;
    bool inside = !isOutside;
    for (const auto& f : kFaces) {
        if (inside) {
            // If inside, the origin is on the fourth corner's side of every face. Four nearly coplanar
            // corners, as polyhedra and rims have them, contain nothing: rounding would decide the sides.
            const Vec3 n = (p(f[1]) - p(f[0])).cross(p(f[2]) - p(f[0])), up = p(f[3]) - p(f[0]);
            const double fourth = n.dot(up);
            const bool flat = fourth * fourth <= kFlat * n.squaredNorm() * up.squaredNorm();
            inside = !flat && -n.dot(p(f[0])) * fourth > 0.0;
        }
        // Of the first face, the shares are known: it is the whole simplex of before.
        const Shares shares = f[3] == 3 ? shares_ : ofTriangle(p(f[0]), p(f[1]), p(f[2]));
        if (const double d = shares.nearest.squaredNorm(); d < least)
            least = d, best = shares, face = {f[0], f[1], f[2]};
    }
    return !inside;
}

Simplex::Step Simplex::add(const Corner& next, bool isOutside) {
    corners_[count_] = next;
    std::array<int, 3> face{0, 1, 2};
    Shares best;
    if (count_ == 1)
        best = ofSegment(p(0), p(1) - p(0), -p(0).dot(p(1) - p(0)));
    else if (count_ == 2)
        best = ofTriangle(p(0), p(1), p(2));
    else if (!nearestFace(face, best, isOutside))
        return Step::inside;
    Vec3 v = Vec3::Zero();
    int kept = 0;
    for (int i = 0; i < 3; ++i)
        if (best.of[i] > 0.0) v += best.of[i] * p(face[i]), ++kept;
    if (kept == 0) return isOutside ? Step::done : Step::inside;
    if (!(v.squaredNorm() < v_.squaredNorm())) return Step::done;
    count_ = 0;
    for (int i = 0; i < 3; ++i) {
        if (!(best.of[i] > 0.0)) continue;
        if (face[i] != count_) corners_[count_] = corners_[face[i]];
        best.of[count_++] = best.of[i];
    }
    shares_ = best;
    v_ = v;
    return Step::nearer;
}

Closest Simplex::result() const {
    Closest closest;
    closest.onA = closest.onB = Vec3::Zero();
    for (int i = 0; i < count_; ++i) {
        closest.onA += shares_.of[i] * corners_[i].onA;
        closest.onB += shares_.of[i] * corners_[i].onB;
    }
    closest.distance = v_.norm();
    if (closest.distance > 0.0) closest.normal = v_ / closest.distance;
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
    Simplex s(support(between.squaredNorm() > 0.0 ? Vec3(-between) : Vec3(Vec3::UnitY())));
    const double touching = 1e-12 * (a.reach() + b.reach() + between.norm());
    for (int i = 0; i < kMostSupports; ++i) {
        const Vec3 v = s.nearest();
        const double square = v.squaredNorm();
        if (square <= touching * touching) return {};
        const Corner next = support(-v);
        const double along = v.dot(next.p);  // over |v|: a lower bound of the distance
        if (square - along <= kEpsilon * square || s.holds(next.p)) break;
        if (along > 0.0 && along * along > enough * enough * square) {
            Closest far = s.result();
            far.distance = along / std::sqrt(square);
            return far;
        }
        const Simplex::Step step = s.add(next, along > 0.0);
        if (step == Simplex::Step::inside) return {};
        if (step == Simplex::Step::done) break;
    }
    return s.result();
}

}  // namespace engine
