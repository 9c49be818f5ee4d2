// Nets and lattices: bodies with joints to all neighbours, in rows, columns and layers. There are more loops than a
// tree takes, and often more rows than the bodies can move in.
#include <gtest/gtest.h>

#include <functional>

#include "tests/support/joints.h"

namespace engine {
namespace {

using GridPlace = std::array<int, 3>;

struct JointNet {
    const char* name;
    GridPlace size;
    JointType type;
    Vec3 half;  // m, of a box; a ball's radius is the first, if the others are 0
    double spacing;
    std::function<bool(const GridPlace&)> isHeld;
    std::function<double(const GridPlace&)> density;  // kg/m^3
    double seconds, mostApart;                        // s, m
    double spin = 0.0;                                // rad/s, of the net as a whole at the beginning
};

double asWater(const GridPlace&) { return 1000.0; }
bool atTheEdge(const GridPlace& at) { return at[1] == 0; }
bool atTheCorner(const GridPlace& at) { return at[0] == 0 && at[1] == 0; }

// With sweeps alone, all but the plate come apart or gain energy. They hold for a minute too.
const JointNet kNets[] = {
    {"ByAnEdge", {20, 20, 1}, JointType::ball, {0.1, 0, 0}, 0.5, atTheEdge, asWater, 2, 0.1},
    {"ByACorner", {12, 12, 1}, JointType::ball, {0.1, 0, 0}, 0.5, atTheCorner, asWater, 4, 0.1},
    {"Strip", {5, 40, 1}, JointType::ball, {0.1, 0, 0}, 0.5, atTheEdge, asWater, 3, 0.1},
    {"Lattice", {5, 5, 5}, JointType::ball, {0.1, 0, 0}, 0.5,
     [](const GridPlace& at) { return at[0] == 0 && at[2] == 0; }, asWater, 3, 0.05},
    {"SmallBalls", {10, 10, 1}, JointType::ball, {0.02, 0, 0}, 0.5, atTheEdge, asWater, 3, 0.05},
    {"TonAtTheCorner", {10, 10, 1}, JointType::ball, {0.1, 0, 0}, 0.5, atTheCorner,
     [](const GridPlace& at) { return at[0] + at[1] == 18 ? 240e3 : 1000.0; }, 3, 0.1},
    {"Hinges", {12, 12, 1}, JointType::hinge, {0.2, 0.02, 0.2}, 0.5, atTheEdge, asWater, 4, 0.05},
    {"Spinning", {10, 10, 1}, JointType::ball, {0.1, 0, 0}, 0.5,
     [](const GridPlace&) { return false; }, asWater, 2, 0.1, 20.0},
    // It cannot sag: it is as flat as it is wide.
    {"Taut", {14, 14, 1}, JointType::ball, {0.05, 0, 0}, 0.25,
     [](const GridPlace& at) { return at[0] % 13 == 0 || at[1] % 13 == 0; },
     [](const GridPlace& at) { return at[0] == 7 && at[1] == 7 ? 160e3 : 1000.0; }, 2, 0.005},
    {"WeldedPlate", {10, 10, 1}, JointType::weld, {0.2, 0.05, 0.2}, 0.5, atTheEdge, asWater, 2, 0.005},
};

/// The net in its plane, which is level; `scale` is the energy to compare with.
World worldOfNet(const JointNet& net, const Settings& settings, double& scale) {
    World world(settings);
    const int nx = net.size[0], ny = net.size[1], nz = net.size[2];
    const auto numberOf = [&](int i, int k, int l) { return BodyId{(l * ny + k) * nx + i}; };
    const auto join = [&](BodyId a, BodyId b) {
        if (world.def(a).kind == BodyKind::fixed && world.def(b).kind == BodyKind::fixed) return;
        const Vec3 way = world.pose(b).position - world.pose(a).position;
        const Vec3 axis = way.cross(Vec3::UnitY()).normalized(), at = world.pose(a).position + 0.5 * way;
        world.add(support::jointAt(world, net.type, a, b, at, net.type == JointType::hinge ? axis : Vec3::UnitZ()));
    };
    const Vec3 centre = 0.5 * net.spacing * Vec3(nx - 1, 1 - nz, ny - 1), spin(0, net.spin, 0);
    for (int l = 0; l < nz; ++l)
        for (int k = 0; k < ny; ++k)
            for (int i = 0; i < nx; ++i) {
                const Vec3 at = net.spacing * Vec3(i, -l, k);
                BodyDef def = support::body(
                    net.half.y() == 0.0 ? Shape::sphere(net.half.x()) : Shape::box(2.0 * net.half), at);
                def.collide = false;
                def.mass.reset();
                def.material.density = net.density({i, k, l});
                if (net.isHeld({i, k, l})) def.kind = BodyKind::fixed;
                else def.velocity = spin.cross(at - centre), def.spin = spin;
                const BodyId id = world.add(def);
                scale += support::kGravity * 0.5 * net.spacing * ny * world.mass(id);
                if (i > 0) join(numberOf(i - 1, k, l), id);
                if (k > 0) join(numberOf(i, k - 1, l), id);
                if (l > 0) join(numberOf(i, k, l - 1), id);
            }
    if (net.spin != 0.0) scale = world.energy().kinetic, world.setGravity(Vec3::Zero());
    return world;
}

class Nets : public testing::TestWithParam<JointNet> {};
INSTANTIATE_TEST_SUITE_P(Joints, Nets, testing::ValuesIn(kNets),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_P(Nets, HoldAndNeverGainEnergy) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        double scale = 0.0, high = 0.0, apart = 0.0;
        World world = worldOfNet(GetParam(), settings, scale);
        const double first = world.energy().total();
        for (int i = 0; i < GetParam().seconds * 60; ++i) {
            ASSERT_TRUE(world.step(support::kStep)) << i;
            high = larger(high, (world.energy().total() - first) / scale);
            apart = larger(apart, world.errors().separation);
        }
        EXPECT_LT(high, 0.005);
        EXPECT_LT(apart, GetParam().mostApart);
        EXPECT_EQ(world.report().trouble, Trouble::none);
    }
}

}  // namespace
}  // namespace engine
