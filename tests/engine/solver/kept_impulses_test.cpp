// The energy that a guess brings, measured with the velocities, is least for the share that is kept.
#include "engine/solver/kept_impulses.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/dynamics/energy.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

constexpr int kLinks = 5;

/// A chain of balls, and one point joint outside the trees from its second link to its last.
struct GuessedChain {
    Bodies bodies;
    Constraints c;
    JointTrees trees;
    KeptImpulses kept;
    std::vector<Velocity> before;  // without the guess
    double energy = 0.0;           // J, as KeptImpulses counts it
    std::array<double, 6> guess{};

    explicit GuessedChain(std::uint64_t seed) {
        support::Random random(seed);
        addBody(bodies, support::hook(), 0);
        for (int i = 1; i <= kLinks; ++i) {
            BodyDef def = support::body(Shape::sphere(0.5), Vec3(i, 0, 0), random.number(0.5, 2));
            def.velocity = random.vector(1), def.spin = random.vector(1);
            addBody(bodies, def, i);
        }
        std::vector<Joint> joints(kLinks + 1);
        for (int k = 0; k <= kLinks; ++k) connect(joints[k], k);
        trees.build(c.joints, joints, bodies.inverseMasses);
        trees.prepare(joints, bodies);
        const auto first = [](int, int) { return 0; };
        trees.sortInto(1, first);
        c.jointsByGroup.sort(kLinks + 1, 1, [](int) { return 0; });
        c.jointsOutside.sort(kLinks + 1, 1, [&](int k) { return c.joints[k].inTree ? -1 : 0; });
        prepareOuter(joints[kLinks], random);
        kept.measure(bodies, 1, c);
        for (const JointConstraint& joint : c.joints)
            for (const int body : {joint.a, joint.b})
                if (body > 0) energy += kineticEnergyOf(bodies, body);
        before = bodies.velocities;
        trees.begin(0.0, 0.0, before);
    }
    void connect(Joint& joint, int k) {
        JointConstraint row;
        row.joint = k, row.count = 3;
        row.a = k < kLinks ? k : 2, row.b = k < kLinks ? k + 1 : kLinks;
        row.treeRows = k < kLinks ? 3 : 0;
        const Vec3 at(row.a + 0.4, 0.3, 0.1 * k);
        joint.def.a = {row.a}, joint.def.b = {row.b};
        joint.def.anchorA = bodies.poses[row.a].toLocal(at);
        joint.def.anchorB = bodies.poses[row.b].toLocal(at);
        c.joints.push_back(row);
    }
    void prepareOuter(const Joint& joint, support::Random& random) {
        JointConstraint& o = outer();
        const JointRows rows =
            rowsOf(joint.def.type, geometryOf(joint, bodies.poses[o.a], bodies.poses[o.b]));
        for (int i = 0; i < 3; ++i) {
            o.rows[i] = makeRow(rows.j[i], bodies.inverseMasses[o.a], bodies.inverseMasses[o.b]);
            o.bias[i] = random.number(-0.2, 0.2), o.softness[i] = random.number(0.1, 0.3);
            guess[i] = random.number(-1, 1);
        }
        o.kept = 0.9;
    }
    JointConstraint& outer() { return c.joints.back(); }

    double kinetic(std::vector<Velocity> v) {
        Correction unused;
        trees.solveVelocities(v, unused);
        std::swap(v, bodies.velocities);
        double sum = 0.0;
        for (int i = 1; i <= kLinks; ++i) sum += kineticEnergyOf(bodies, i);
        std::swap(v, bodies.velocities);
        return sum;
    }
    std::vector<Velocity> with(double scale) {
        std::vector<Velocity> v = before;
        JointConstraint o = outer();
        for (int i = 0; i < 3; ++i) push(o, i, scale * guess[i], v[o.a], v[o.b]);
        return v;
    }
    /// J: f of this multiple of the guess.
    double brought(double scale) {
        double f = kinetic(with(scale)) - kinetic(before);
        for (int i = 0; i < 3; ++i) {
            const double lambda = scale * guess[i];
            f += lambda * outer().bias[i] + 0.5 * outer().softness[i] * lambda * lambda;
        }
        return f;
    }
    double slope() { return brought(0.5) - brought(-0.5); }
    /// Turns the guess so that a little of it takes energy away; with -1, so that it brings energy.
    void point(double sign) {
        if (sign * slope() > 0.0)
            for (double& g : guess) g = -g;
    }
    /// The multiple of the guess that brings this share of the energy.
    double bringing(double share) {
        const double s = slope(), curvature = brought(1.0) + brought(-1.0);
        return (-s + std::sqrt(s * s + 2.0 * curvature * share * energy)) / curvature;
    }
    /// The multiple that is left of one.
    double checked(double scale) {
        for (int i = 0; i < 3; ++i) outer().lambda[i] = scale * guess[i];
        std::vector<Velocity> v = with(scale);
        kept.check(c, trees, v);
        const double left = outer().lambda[0] / guess[0];
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(outer().lambda[i], left * guess[i], 1e-12);
        EXPECT_NEAR(kinetic(v), kinetic(with(left)), 1e-9);  // v has what is left, and no more
        return left;
    }
};

TEST(KeptImpulses, ReduceABadGuessToTheShareThatBringsLeast) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        GuessedChain chain(seed);
        ASSERT_FALSE(chain.outer().inTree);
        chain.point(1.0);
        const double left = chain.checked(chain.bringing(0.26));
        EXPECT_GT(left, 0.01);
        EXPECT_NEAR(chain.brought(left + 0.1), chain.brought(left - 0.1), 1e-9);
        EXPECT_LT(chain.brought(left), chain.brought(left + 0.1));
    }
}

TEST(KeptImpulses, LeaveAGuessThatBringsLessThanAQuarter) {
    GuessedChain chain(1);
    chain.point(1.0);
    EXPECT_DOUBLE_EQ(chain.checked(chain.bringing(0.24)), chain.bringing(0.24));
}

TEST(KeptImpulses, DropAGuessThatOnlyBringsEnergy) {
    GuessedChain chain(2);
    chain.point(-1.0);
    EXPECT_EQ(chain.checked(chain.bringing(0.3)), 0.0);
}

TEST(KeptImpulses, AreOnlyCheckedWhereABodyTurns) {
    GuessedChain chain(3);
    chain.outer().kept = 1.0;
    chain.point(1.0);
    EXPECT_DOUBLE_EQ(chain.checked(chain.bringing(0.5)), chain.bringing(0.5));
}

}  // namespace
}  // namespace engine
