// No body falls through a surface: bodies that ignore each other are dropped and shot at the corners, edges
// and faces of meshes and height fields, 125 per mesh, at 1 to 300 m/s. A thousand in tests/run; with
// IMPULSE_LONG in the environment (tests/run --long), a hundred thousand.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "tests/behaviour/torture/worlds.h"

namespace torture {
namespace {

using namespace engine;
using support::Random;

constexpr int kLines = 24;      // of the grid, in each direction
constexpr double kHalf = 8.0;   // m
constexpr int kDrops = 125;

enum class Lines { regular, uneven, field, free };

/// Triangles over a square: a grid with diagonals in either direction, regular or with uneven spacing; a height
/// field; or triangles split at random points, with slivers and corners of many triangles.
class Ground {
public:
    Ground(Random& r, bool rough, Lines lines) : lines_(lines) {
        const double height = rough ? logarithmic(r, 0.05, 0.8) : 0.0;
        const auto raise = [&](double x, double z) { corners_.push_back({x, r.number(0, 1) * height, z}); };
        if (lines == Lines::free) split(r, raise);
        else makeGrid(r, raise);
    }
    Shape shape() const {
        if (lines_ != Lines::field) return Shape::meshOf(corners_, faces_);
        std::vector<double> heights;
        for (const Vec3& corner : corners_) heights.push_back(corner.y());
        return Shape::heightField(kLines, kLines, 2 * kHalf / (kLines - 1), heights);
    }
    double height(double x, double z) const {
        for (const auto& face : faces_) {
            const Vec3 shares = sharesOf(face, x, z);
            if (shares.minCoeff() < -1e-9) continue;
            const auto y = [&](int i) { return corners_[face[i]].y(); };
            return shares[0] * y(0) + shares[1] * y(1) + shares[2] * y(2);
        }
        return 0.0;
    }
    /// A corner, a point on an edge, or any point, away from the rim.
    Vec3 target(Random& r, int where) const {
        for (;;) {
            const auto& face = faces_[std::size_t(r.number(0, double(faces_.size())))];
            Vec3 shares(r.number(0, 1), r.number(0, 1), r.number(0, 1));
            if (where < 2) shares[1] = 0.0;
            if (where < 1) shares[2] = 0.0;
            shares /= shares.sum();
            const Vec3 at = shares[0] * corners_[face[0]] + shares[1] * corners_[face[1]] + shares[2] * corners_[face[2]];
            if (larger(std::abs(at.x()), std::abs(at.z())) < 6.0) return at;
        }
    }

private:
    template <class Raise>
    void makeGrid(Random& r, Raise raise) {
        const double cell = 2 * kHalf / (kLines - 1);
        std::vector<double> x, z;
        for (std::vector<double>* lines : {&x, &z})
            for (int i = 0; i < kLines; ++i) {
                const bool moves = lines_ == Lines::uneven && i > 0 && i + 1 < kLines;
                lines->push_back(i * cell - kHalf + (moves ? r.number(-0.48, 0.48) * cell : 0.0));
            }
        for (int i = 0; i < kLines * kLines; ++i) raise(x[i % kLines], z[i / kLines]);
        for (int i = 0; i + kLines < kLines * kLines; ++i) {
            if (i % kLines == kLines - 1) continue;
            const int a = i, b = a + 1, d = a + kLines, e = d + 1;
            if (lines_ == Lines::field || chance(r, 0.5)) faces_.push_back({a, d, b}), faces_.push_back({b, d, e});
            else faces_.push_back({a, d, e}), faces_.push_back({a, e, b});
        }
    }
    template <class Raise>
    void split(Random& r, Raise raise) {
        for (const double z : {-kHalf, kHalf})
            for (const double x : {-kHalf, kHalf}) raise(x, z);
        faces_ = {{0, 2, 1}, {1, 2, 3}};
        for (int i = 4; i < 300; ++i) {
            const double x = r.number(-kHalf, kHalf), z = r.number(-kHalf, kHalf);
            std::size_t k = 0;
            while (sharesOf(faces_[k], x, z).minCoeff() < 0.0) ++k;
            if (sharesOf(faces_[k], x, z).minCoeff() < 1e-6) continue;
            raise(x, z);
            const int corner = int(corners_.size()) - 1;
            const auto [a, b, c] = faces_[k];
            faces_[k] = {a, b, corner};
            faces_.push_back({b, c, corner}), faces_.push_back({c, a, corner});
        }
    }
    /// Barycentric, seen from above.
    Vec3 sharesOf(const std::array<int, 3>& face, double x, double z) const {
        const Vec3 &a = corners_[face[0]], &b = corners_[face[1]], &c = corners_[face[2]];
        const auto area = [&](double px, double pz, const Vec3& q, const Vec3& s) {
            return (q.x() - px) * (s.z() - pz) - (q.z() - pz) * (s.x() - px);
        };
        return Vec3(area(x, z, b, c), area(x, z, c, a), area(x, z, a, b)) / area(a.x(), a.z(), b, c);
    }

    Lines lines_;
    std::vector<Vec3> corners_;
    std::vector<std::array<int, 3>> faces_;
};

/// Of about the size s (m).
Shape anyShape(Random& r, int kind, double s) {
    switch (kind) {
        case 0: return Shape::sphere(s);
        case 1: return Shape::box(s * Vec3(r.number(0.3, 2), r.number(0.3, 2), r.number(0.3, 2)));
        case 2: return Shape::capsule(0.5 * s, s * r.number(1.1, 4));
        case 3: return Shape::cylinder(0.7 * s, s * r.number(0.2, 2));
        case 4: return Shape::cone(0.7 * s, s * r.number(0.4, 2));
        case 5: {
            std::vector<Vec3> points;
            for (int i = 0; i < 12; ++i) points.push_back(r.vector(s));
            return *Shape::hullOf(points);
        }
        default: {
            std::vector<ShapePart> parts;
            for (int i = 0; i < 3; ++i) {
                const Vec3 place = r.vector(0.6 * s);
                parts.push_back({anyShape(r, i, 0.5 * s), {place, r.rotation()}, 1.0});
            }
            return Shape::compound(parts);
        }
    }
}

BodyDef anyDrop(Random& r, const Ground& ground, int number) {
    BodyDef def;
    def.shape = anyShape(r, number % 7, logarithmic(r, 0.02, 0.6));
    def.groups = def.ignores = 1;
    def.material.restitution = chance(r, 0.3) ? 0.5 : 0.0;
    def.material.friction = r.number(0, 1);
    const Vec3 at = ground.target(r, number / 7 % 3);
    const double speed = logarithmic(r, 1, 300);
    Vec3 way = -Vec3::UnitY();
    if (chance(r, 0.5)) way = (way + r.vector(1)).normalized();
    if (way.y() > -0.3) way = -Vec3::UnitY();
    const double reach = reachOf(def.shape);
    double distance = larger(speed * r.number(0.05, 0.35), 1.0 + reach);
    if (way.x() != 0.0) distance = smaller(distance, 6.0 + reach);
    def.pose.position = at - distance * way;
    if (chance(r, 0.7)) def.pose.rotation = r.rotation();
    if (chance(r, 0.5)) def.spin = r.vector(30);
    def.velocity = speed * way;
    return def;
}

class Drops : public testing::TestWithParam<int> {};

TEST_P(Drops, NoneFallsThrough) {
    Random r(static_cast<std::uint64_t>(GetParam()) + 1000);
    const Ground ground(r, GetParam() % 2 == 1, static_cast<Lines>(GetParam() / 2 % 4));
    World world(GetParam() % 3 == 2 ? Settings::fast() : Settings::steady());
    world.add(support::fixed(ground.shape()));
    for (int i = 0; i < kDrops; ++i) world.add(anyDrop(r, ground, i));
    std::vector<bool> gone(kDrops + 1, false);  // over the edge
    const auto isBeyond = [&](int i) {
        const Vec3& at = world.pose({i}).position;
        return larger(std::abs(at.x()), std::abs(at.z())) > kHalf - 0.1;
    };
    for (int step = 0; step < 75; ++step) {
        ASSERT_TRUE(world.step(support::kStep));
        for (const Incident& incident : world.report().incidents)  // a needle at 300 m/s spins above 1e4 rad/s
            ASSERT_EQ(incident.trouble, Trouble::velocityTooLarge) << step;
        for (int i = 1; i <= kDrops; ++i) gone[i] = gone[i] || isBeyond(i);
    }
    int held = 0;
    for (int i = 1; i <= kDrops; ++i) {
        if (gone[i]) continue;
        ++held;
        const Vec3& at = world.pose({i}).position;
        // The centre of a compound may be outside all its parts.
        const double below = (i - 1) % 7 == 6 ? 0.05 : 1e-3;
        EXPECT_GT(at.y(), ground.height(at.x(), at.z()) - below)
            << "body " << i << " at " << world.def({i}).velocity.norm() << " m/s";
    }
    EXPECT_GT(held, kDrops / 2);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Drops,
                         testing::Range(0, std::getenv("IMPULSE_LONG") ? 800 : 8));

}  // namespace
}  // namespace torture
