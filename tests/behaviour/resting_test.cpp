// mission 24, 25: resting bodies keep their contacts.
#include <gtest/gtest.h>

#include <set>

#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::run;

class Resting : public testing::TestWithParam<bool> {
protected:
    static Settings settings() { return GetParam() ? Settings::steady() : Settings::seed(); }
};

TEST_P(Resting, ABoxKeepsItsFourFeaturesForTenSeconds) {
    World world = support::stack(1, settings());
    std::set<int> features;
    for (int i = 0; i < 600; ++i) {
        world.step(support::kStep);
        ASSERT_EQ(world.contacts().size(), 4u) << "step " << i;
        for (const ContactState& c : world.contacts()) features.insert(c.feature);
    }
    EXPECT_EQ(features.size(), 4u);
}

// mission 25: the penetration settles between 0.5 and 1.2 slop
TEST_P(Resting, ABoxSettlesWithinTheSlop) {
    World world(settings());
    world.add(support::floorPlane());
    const BodyId box = world.add(support::body(Shape::box({1, 1, 1}), {0, 0.49, 0}, 1000));
    run(world, 600);
    EXPECT_LT(world.velocity(box).norm(), 1e-3);
    EXPECT_GT(world.errors().penetration, 0.5 * settings().slop);
    EXPECT_LT(world.errors().penetration, 1.2 * settings().slop);
}

TEST_P(Resting, EveryPairOfShapesRests) {
    const Shape shapes[] = {Shape::box({1, 1, 1}), Shape::sphere(0.5), Shape::capsule(0.3, 1.4)};
    const Shape tables[] = {Shape::plane({0, 1, 0}), Shape::box({8, 1, 8})};
    for (const Shape& shape : shapes)
        for (const Shape& table : tables) {
            World world(settings());
            world.add(support::fixed(
                table, table.type == ShapeType::plane ? Vec3(0, 0, 0) : Vec3(0, -0.5, 0)));
            BodyDef def = support::body(shape, {0, 0.52, 0}, 10);
            if (shape.type == ShapeType::capsule) {
                def.pose.rotation = Quat(std::sqrt(0.5), 0, 0, std::sqrt(0.5));  // lying
                def.pose.position.y() = 0.32;
            }
            const BodyId id = world.add(def);
            run(world, 300);
            EXPECT_LT(world.velocity(id).norm(), 2e-3);
            EXPECT_NEAR(world.pose(id).position.y(), def.pose.position.y() - 0.02, 0.008);
        }
}

INSTANTIATE_TEST_SUITE_P(Presets, Resting, testing::Bool(), [](const auto& one) {
    return one.param ? "steady" : "seed";
});

}  // namespace
}  // namespace engine
