// Structures that people build to test an engine: tall stacks, card houses, towers, dominoes.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::run;

BodyDef rough(BodyDef def, double friction) {
    def.material.friction = friction;
    return def;
}

/// The largest displacement of a body from its start, m.
double moved(const World& world, const std::vector<Vec3>& start) {
    double most = 0.0;
    for (int i = 0; i < static_cast<int>(start.size()); ++i)
        most = std::max(most, (world.pose({i + 1}).position - start[i]).norm());
    return most;
}

std::vector<Vec3> places(const World& world) {
    std::vector<Vec3> all;
    for (int i = 1; i < world.bodyCount(); ++i) all.push_back(world.pose({i}).position);
    return all;
}

TEST(Structures, FortyBoxesStand) {
    World world = support::stack(40);
    const std::vector<Vec3> start = places(world);
    run(world, 600);
    EXPECT_LT(moved(world, start), 12e-3);  // a quarter of a millimetre in each joint
}

/// Thirty layers of three blocks, laid across each other.
TEST(Structures, ATowerOfThirtyLayersStands) {
    World world;
    world.add(rough(support::floorPlane(), 0.5));
    for (int layer = 0; layer < 30; ++layer)
        for (int i = -1; i <= 1; ++i) {
            const bool along = layer % 2 == 0;
            const Vec3 at(along ? 0.0 : 1.0 * i, 0.3 + 0.6 * layer, along ? 1.0 * i : 0.0);
            const Vec3 size = along ? Vec3(3, 0.6, 0.98) : Vec3(0.98, 0.6, 3);
            world.add(rough(body(Shape::box(size), at, 500.0), 0.5));
        }
    const std::vector<Vec3> start = places(world);
    run(world, 600);
    EXPECT_LT(moved(world, start), 20e-3);  // 18 m high, it sways a little without damage
}

/// Every body 0.1 mm and 0.2 mrad off.
void shake(World& world, std::uint64_t seed) {
    support::Random random(seed);
    for (int i = 1; i < world.bodyCount(); ++i) {
        Pose pose = world.pose({i});
        pose.position += random.vector(1e-4);
        const Vec3 half = random.vector(1e-4);
        pose.rotation = Quat(1.0, half.x(), half.y(), half.z()) * pose.rotation;
        world.setPose({i}, pose);
    }
}

/// Pairs of leaning cards, a card over every gap, and one pair less on each storey; each storey sunk into the one
/// below by `overlap` (m).
World cardHouse(int storeys, double friction, const Settings& settings = Settings::steady(), double overlap = 0.0) {
    constexpr double kLength = 1.5, kThickness = 0.02;  // m
    const double lean = radians(15.0), s = sine(lean), c = cosine(lean);
    const double aside = 0.5 * (kLength * s + kThickness * c), height = kLength * c + kThickness * s;
    const double pitch = 2.0 * kLength * s + 0.1;  // between neighbouring pairs
    World world(settings);
    world.add(rough(support::floorPlane(), friction));
    const auto card = [&](double x, double y, double degrees, double length) {
        BodyDef def = body(Shape::box({kThickness, length, 1.0}), {x, y, 0}, 10.0);
        def.pose.rotation = turnAboutXyz({0, 0, radians(degrees)});
        world.add(rough(def, friction));
    };
    for (int storey = 0; storey < storeys; ++storey) {
        const double floor = storey * (height + kThickness - overlap);
        const int pairs = storeys - storey;
        for (int i = 0; i < pairs; ++i) {
            const double x = pitch * (i + 0.5 * storey);
            card(x - aside, floor + 0.5 * height, -15.0, kLength);
            card(x + aside, floor + 0.5 * height, 15.0, kLength);
            if (i > 0) card(x - 0.5 * pitch, floor + height + 0.5 * kThickness, 90.0, pitch - 0.01);
        }
    }
    return world;
}

TEST(Structures, AHouseOfCardsStands) {
    World world = cardHouse(4, 0.6);
    const std::vector<Vec3> start = places(world);
    run(world, 600);
    EXPECT_LT(moved(world, start), 20e-3);
}

// Pushed apart fast, they would fall.
TEST(Structures, AHouseOfCardsThatOverlapStands) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        World world = cardHouse(3, 0.6, settings, 0.01);
        const std::vector<Vec3> start = places(world);
        run(world, 600);
        EXPECT_LT(moved(world, start), 60e-3);
    }
}

// Two sub-steps and eight sweeps leave it without support at first, and it loses its balance for good.
TEST(Structures, AHouseOfCardsStandsInPresetFast) {
    for (const int seed : {0, 1, 2}) {
        World world = cardHouse(5, 0.6, Settings::fast());
        if (seed > 0) shake(world, seed);
        const std::vector<Vec3> start = places(world);
        run(world, 3600);
        EXPECT_LT(moved(world, start), 20e-3) << seed;
    }
}

TEST(Structures, AHouseOfSlipperyCardsFalls) {
    World world = cardHouse(4, 0.05);
    const std::vector<Vec3> start = places(world);
    run(world, 300);
    EXPECT_GT(moved(world, start), 0.5);
}

/// A row of dominoes at a distance; the first begins to turn at `push` (rad/s).
World dominoes(int count, double apart, double push) {
    World world;
    world.add(rough(support::floorPlane(), 0.6));
    for (int i = 0; i < count; ++i) {
        BodyDef def = body(Shape::box({0.25, 1.0, 0.5}), {apart * i, 0.5, 0}, 5.0);
        if (i == 0) def.spin = Vec3(0, 0, -push), def.velocity = Vec3(0.5 * push, 0, 0);
        world.add(rough(def, 0.6));
    }
    return world;
}

void expectAllFallen(const World& world) {
    for (int i = 1; i < world.bodyCount(); ++i) {
        const Vec3 up = world.pose({i}).rotation * Vec3::UnitY();
        EXPECT_LT(up.y(), 0.8) << "domino " << i << " still stands";
    }
}

TEST(Structures, DominoesStandUntilTheFirstIsPushed) {
    World still = dominoes(30, 0.5, 0.0);
    const std::vector<Vec3> start = places(still);
    run(still, 600);
    EXPECT_LT(moved(still, start), 1e-3);

    World pushed = dominoes(30, 0.5, 2.5);
    run(pushed, 600);
    expectAllFallen(pushed);
}

// Each reaches the next only when it is nearly down, and then slips on it.
TEST(Structures, DominoesAtTheirHeightFromEachOtherFallToo) {
    World world = dominoes(15, 1.01, 2.5);
    run(world, 900);
    expectAllFallen(world);
}

/// Loops of rods: joints that do not fit in one forest are left to the next (solver/joint_forests.h).
struct Net {
    static constexpr int kSide = 8;
    World world;
    std::vector<BodyId> knots;

    Net() {
        for (int i = 0; i < kSide * kSide; ++i) {
            BodyDef knot = body(Shape::sphere(0.05), {0.25 * (i % kSide), 5, 0.25 * (i / kSide)}, 0.1);
            knot.collide = false;
            knots.push_back(world.add(knot));
        }
        for (int i = 0; i < kSide * kSide; ++i) {
            if (i % kSide + 1 < kSide) support::rod(world, knots[i], knots[i + 1]);
            if (i + kSide < kSide * kSide) support::rod(world, knots[i], knots[i + kSide]);
        }
        for (const int corner : {0, kSide - 1}) {
            const Vec3 at = world.pose(knots[corner]).position;
            support::join(world, JointType::ball, world.add(support::hook(at)), knots[corner], at);
        }
    }
};

TEST(Net, OfRodsSwingsWithoutGainingEnergyOrComingApart) {
    Net net;
    const double start = net.world.energy().total();
    double most = start, worst = 0.0;
    for (int i = 0; i < 300; ++i) {
        ASSERT_TRUE(net.world.step(support::kStep)) << i;
        most = larger(most, net.world.energy().total());
        worst = larger(worst, net.world.errors().separation);
    }
    EXPECT_LT(most, start + 0.05 * 6.4 * support::kGravity);  // as if all rose by 5 cm
    EXPECT_LT(worst, 0.1);
}

}  // namespace
}  // namespace engine
