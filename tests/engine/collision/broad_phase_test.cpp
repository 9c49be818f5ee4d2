#include "engine/collision/broad_phase.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/worlds.h"

namespace engine {
namespace {

Bodies cloud(int count, double reach, std::uint64_t seed) {
    Bodies bodies;
    support::Random random(seed);
    for (int i = 0; i < count; ++i) {
        const double r = random.number(0.2, 0.6);
        BodyDef def = support::body(Shape::sphere(r), random.vector(reach));
        def.velocity = random.vector(1.0);
        if (i % 7 == 0) def.kind = BodyKind::fixed;
        addBody(bodies, def, bodies.count());
    }
    return bodies;
}

std::set<PairKey> everyPairByBounds(const Bodies& bodies, const BroadPhase& broad) {
    std::set<PairKey> pairs;
    for (int i = 0; i < bodies.count(); ++i)
        for (int j = i + 1; j < bodies.count(); ++j)
            if ((bodies.isDynamic(i) || bodies.isDynamic(j)) &&
                broad.bounds(i).overlaps(broad.bounds(j)))
                pairs.insert({i, j});
    return pairs;
}

TEST(BroadPhase, MissesNoPairWhileBodiesMove) {
    Bodies bodies = cloud(200, 4.0, 1);
    BroadPhase broad;
    for (int step = 0; step < 40; ++step) {
        broad.update(bodies, 0.02, support::kStep);
        const std::set<PairKey> found(broad.pairs().begin(), broad.pairs().end());
        EXPECT_EQ(found.size(), broad.pairs().size());  // each once
        EXPECT_TRUE(std::is_sorted(broad.pairs().begin(), broad.pairs().end()));
        for (const PairKey& pair : everyPairByBounds(bodies, broad)) EXPECT_TRUE(found.count(pair));
        ASSERT_TRUE(broad.tree().isConsistent());
        for (int i = 0; i < bodies.count(); ++i)
            if (bodies.isDynamic(i)) bodies.poses[i].position += 0.1 * bodies.velocities[i].linear;
    }
}

/// A leaf holds the next steps of a fast body too: the pair is known before it may meet.
TEST(BroadPhase, LooksAheadOfFastBodies) {
    Bodies bodies;
    BodyDef ball = support::body(Shape::sphere(0.1), {0, 0, 0});
    ball.velocity = {12, 0, 0};  // 0.2 m a step
    addBody(bodies, ball, 0);
    addBody(bodies, support::body(Shape::sphere(0.1), {0.8, 0, 0}), 1);
    addBody(bodies, support::body(Shape::sphere(0.1), {-0.8, 0, 0}), 2);
    BroadPhase broad;
    broad.update(bodies, 0.02, support::kStep);
    EXPECT_EQ(broad.pairs(), std::vector<PairKey>({{0, 1}}));
    EXPECT_FALSE(broad.boundsMeet({0, 1}));
}

// For n bodies in a volume that grows with n, the number of pairs grows like n.
TEST(BroadPhase, StaysBelowThePairsOfAll) {
    Bodies bodies = cloud(4000, 20.0, 2);
    BroadPhase broad;
    broad.update(bodies, 0.02, support::kStep);
    EXPECT_LT(broad.pairs().size(), 4u * 4000u);  // of 8 million
    EXPECT_LT(broad.tree().height(), 40);         // log2(4000) = 12
}

TEST(BroadPhase, SortedInsertionDoesNotMakeAList) {
    Bodies bodies;
    for (int i = 0; i < 1000; ++i)
        addBody(bodies, support::body(Shape::sphere(0.4), {1.0 * i, 0, 0}), bodies.count());
    BroadPhase broad;
    broad.update(bodies, 0.02, support::kStep);
    EXPECT_LT(broad.tree().height(), 60);
}

TEST(BroadPhase, APlaneMeetsEverythingDynamicAndARemovedBodyNothing) {
    Bodies bodies = cloud(20, 3.0, 3);
    const int plane = bodies.count();
    addBody(bodies, support::floorPlane(), plane);
    BroadPhase broad;
    broad.update(bodies, 0.02, support::kStep);
    const auto withPlane = [&] {
        return std::count_if(broad.pairs().begin(), broad.pairs().end(),
                             [&](const PairKey& p) { return p.b == plane; });
    };
    EXPECT_EQ(withPlane(), 17);  // 20 without the three fixed ones
    bodies.present[1] = 0;
    broad.remove(1);
    broad.update(bodies, 0.02, support::kStep);
    EXPECT_EQ(withPlane(), 16);
    for (const PairKey& p : broad.pairs()) EXPECT_TRUE(p.a != 1 && p.b != 1);
}

TEST(Tree, StaysConsistentThroughRandomInsertsAndRemovals) {
    BoundsTree tree;
    support::Random random(4);
    std::vector<int> leaves;
    ASSERT_TRUE(tree.isConsistent());
    for (int i = 0; i < 2000; ++i) {
        if (leaves.size() > 20 && random.number(0, 1) < 0.45) {
            const int k = static_cast<int>(random.number(0, static_cast<double>(leaves.size())));
            tree.remove(leaves[k]);
            leaves.erase(leaves.begin() + k);
        } else {
            const Vec3 p = random.vector(10);
            leaves.push_back(tree.insert({p, p + Vec3::Constant(1)}, i));
        }
        ASSERT_TRUE(tree.isConsistent()) << i;
    }
    int found = 0;
    std::vector<int> open;
    tree.query({Vec3::Constant(-20), Vec3::Constant(20)}, open, [&](int) { ++found; });
    EXPECT_EQ(found, static_cast<int>(leaves.size()));
}

}  // namespace
}  // namespace engine
