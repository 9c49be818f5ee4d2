// No body falls through a surface: bodies that ignore each other are dropped and shot at the corners, edges
// and faces of meshes, 250 per mesh, at 1 to 300 m/s. A thousand in tests/run; with IMPULSE_LONG in the
// environment (tests/run --long), a hundred thousand.
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
constexpr int kDrops = 250;

/// A grid of triangles with diagonals in either direction, flat or rough, and uneven spacing.
class Ground {
public:
    Ground(Random& r, bool rough, bool irregular) {
        const double cell = 2 * kHalf / (kLines - 1);
        const double height = rough ? logarithmic(r, 0.05, 0.8) : 0.0;
        for (std::vector<double>* lines : {&x_, &z_})
            for (int i = 0; i < kLines; ++i) {
                const bool moves = irregular && i > 0 && i + 1 < kLines;
                lines->push_back(i * cell - kHalf + (moves ? r.number(-0.48, 0.48) * cell : 0.0));
            }
        for (int i = 0; i < kLines * kLines; ++i) {
            corners_.push_back({x_[i % kLines], r.number(0, 1) * height, z_[i / kLines]});
            falling_.push_back(chance(r, 0.5));
        }
    }
    const Vec3& corner(int i, int j) const { return corners_[j * kLines + i]; }

    Shape shape() const {
        std::vector<std::array<int, 3>> faces;
        for (int j = 0; j + 1 < kLines; ++j)
            for (int i = 0; i + 1 < kLines; ++i) {
                const int a = j * kLines + i, b = a + 1, d = a + kLines, e = d + 1;
                if (falling_[a]) faces.push_back({a, d, b}), faces.push_back({b, d, e});
                else faces.push_back({a, d, e}), faces.push_back({a, e, b});
            }
        return Shape::meshOf(corners_, faces);
    }

    double height(double x, double z) const {
        const int i = cellOf(x_, x), j = cellOf(z_, z);
        const double u = (x - x_[i]) / (x_[i + 1] - x_[i]), v = (z - z_[j]) / (z_[j + 1] - z_[j]);
        const double a = corner(i, j).y(), b = corner(i + 1, j).y();
        const double d = corner(i, j + 1).y(), e = corner(i + 1, j + 1).y();
        if (falling_[j * kLines + i])
            return u + v <= 1 ? a + u * (b - a) + v * (d - a) : e + (1 - u) * (d - e) + (1 - v) * (b - e);
        return u > v ? a + u * (b - a) + v * (e - b) : a + v * (d - a) + u * (e - d);
    }

private:
    static int cellOf(const std::vector<double>& lines, double at) {
        int i = 0;
        while (i + 2 < kLines && lines[i + 1] < at) ++i;
        return i;
    }

    std::vector<double> x_, z_;
    std::vector<Vec3> corners_;
    std::vector<bool> falling_;  // the diagonal, from where u + v = 1
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

/// A corner of the ground, a point on an edge, or any point.
Vec3 target(Random& r, const Ground& ground, int where) {
    const int i = 2 + static_cast<int>(r.number(0, kLines - 5));
    const int j = 2 + static_cast<int>(r.number(0, kLines - 5));
    if (where == 0) return ground.corner(i, j);
    const double share = r.number(0, 1);
    if (where == 1) return (1 - share) * ground.corner(i, j) + share * ground.corner(i + 1, j);
    const double x = r.number(-6, 6), z = r.number(-6, 6);
    return {x, ground.height(x, z), z};
}

BodyDef anyDrop(Random& r, const Ground& ground, int number) {
    BodyDef def;
    def.shape = anyShape(r, number % 7, logarithmic(r, 0.02, 0.6));
    def.groups = def.ignores = 1;
    def.material.restitution = chance(r, 0.3) ? 0.5 : 0.0;
    def.material.friction = r.number(0, 1);
    const Vec3 at = target(r, ground, number / 7 % 3);
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
    const Ground ground(r, GetParam() % 2 == 1, GetParam() % 4 >= 2);
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
        ASSERT_TRUE(world.report().incidents.empty()) << step;
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
                         testing::Range(0, std::getenv("IMPULSE_LONG") ? 400 : 4));

}  // namespace
}  // namespace torture
