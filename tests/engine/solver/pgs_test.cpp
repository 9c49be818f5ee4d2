// Projected Gauss-Seidel on forces, with an explicit A and in Catto's form, equals sequential
// impulses: lambda_impulses = h lambda_pgs after every sweep. (mission 23)
#include "engine/solver/pgs.h"

#include <gtest/gtest.h>

#include "engine/solver/impulses.h"
#include "engine/solver/pgs_matrix.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

/// Pseudo-random numbers in [-1, 1], the same on every machine.
class Numbers {
public:
    double next() {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 11) * (2.0 / 9007199254740992.0) - 1.0;
    }
    Vec3 vector() {
        const double x = next(), y = next();
        return {x, y, next()};
    }

private:
    std::uint64_t state_ = 20151;
};

InverseMass randomMass(Numbers& numbers) {
    InverseMass mass;
    mass.linear = 1.0 + 0.5 * numbers.next();
    const Mat3 m = crossMatrix(numbers.vector());
    mass.angular = 3.0 * Mat3::Identity() - 0.5 * m * m;
    return mass;
}

/// Five bodies, two of them linked by a ball joint, and five contacts of four points with friction:
/// 63 rows, 40 of them tangents.
struct Problem {
    Constraints constraints;
    std::vector<Velocity> v{6};
    JointTrees trees;

    Problem() {
        Numbers numbers;
        std::vector<InverseMass> masses(6);
        for (int i = 1; i < 6; ++i) {
            masses[i] = randomMass(numbers);
            v[i] = {numbers.vector() - Vec3(0, 2, 0), numbers.vector()};
        }
        addJoint(numbers, masses);
        for (int i = 0; i < 5; ++i) addContact(numbers, masses, i, i + 1);
        constraints.order = {0, 1, 2, 3, 4};
    }

    void addJoint(Numbers& numbers, const std::vector<InverseMass>& masses) {
        JointConstraint joint;
        joint.a = 2, joint.b = 4, joint.count = 3;
        const Vec3 armA = numbers.vector(), armB = numbers.vector();
        for (int i = 0; i < 3; ++i) {
            joint.rows[i] = makeRow(alongDirection(Vec3::Unit(i), armA, armB), masses[joint.a],
                                    masses[joint.b]);
            joint.lambda[i] = 0.1 * numbers.next();
        }
        constraints.joints.push_back(joint);
    }

    void addContact(Numbers& numbers, const std::vector<InverseMass>& masses, int a, int b) {
        Contact contact;
        contact.a = a, contact.b = b, contact.count = 4;
        contact.normal = (Vec3::UnitY() + 0.3 * numbers.vector()).normalized();
        contact.friction = 0.4;
        ContactGeometry points[4];
        for (int i = 0; i < 4; ++i) {
            points[i] = {numbers.vector(), numbers.vector(), 0.002 * numbers.next()};
            contact.points[i].impulse = 0.2 + 0.1 * numbers.next();  // from a previous step
            contact.points[i].friction = 0.02 * numbers.vector();
        }
        constraints.contacts.push_back(
            makeContactConstraint(contact, points, masses[a], masses[b]));
    }

    std::vector<double> impulses() const {
        std::vector<double> all(constraints.joints[0].lambda.begin(),
                                constraints.joints[0].lambda.begin() + 3);
        for (const ContactConstraint& contact : constraints.contacts) {
            for (int i = 0; i < 4; ++i) all.push_back(contact.rows[i].lambda);
            for (int i = 0; i < 4; ++i)
                for (int t = 0; t < 2; ++t) all.push_back(contact.rows[i].friction[t]);
        }
        return all;
    }
};

template <class Method>
class PgsForms : public testing::Test {};
using Forms = testing::Types<Pgs, PgsMatrix>;
TYPED_TEST_SUITE(PgsForms, Forms);

TYPED_TEST(PgsForms, GiveTheImpulsesAfterEverySweep) {
    Problem swept, forces;
    Settings settings = Settings::seed();
    settings.baumgarte = 0.2, settings.nudges = 0;
    const double h = support::kStep;
    beginSolving(swept.constraints, swept.v, settings, h);
    beginSolving(forces.constraints, forces.v, settings, h);
    GlobalRows rows = globalRows(forces.constraints, forces.v, settings, h);
    ASSERT_EQ(rows.count(), 63);
    TypeParam pgs(rows, 6);
    warmStart(swept.constraints, swept.v, settings);
    double largest = 0.0;
    for (int i = 0; i < 200; ++i) {
        const SweepReport a = sweep(swept.constraints, swept.trees, swept.v, settings);
        const SweepReport b = pgs.sweep();
        EXPECT_NEAR(a.residual, b.residual, 1e-10) << "sweep " << i;
        const std::vector<double> impulses = swept.impulses();
        for (int k = 0; k < rows.count(); ++k) {
            ASSERT_NEAR(impulses[k], h * rows.force[k], 1e-10) << "sweep " << i << " row " << k;
            largest = larger(largest, std::abs(impulses[k]));
        }
    }
    EXPECT_GT(largest, 0.1);  // the problem is not trivial
}

TYPED_TEST(PgsForms, GiveTheVelocities) {
    Problem swept, forces;
    Settings settings = Settings::seed();
    settings.sweeps = settings.minSweeps = 50;
    const double h = support::kStep;
    std::vector<SweepReport> report;
    solveImpulses(swept.constraints, swept.trees, swept.v, settings, h, report);
    beginSolving(forces.constraints, forces.v, settings, h);
    GlobalRows rows = globalRows(forces.constraints, forces.v, settings, h);
    TypeParam pgs(rows, 6);
    for (int i = 0; i < 50; ++i) pgs.sweep();
    takeForces(rows, forces.constraints, forces.v);
    for (int i = 0; i < 6; ++i) {
        EXPECT_NEAR((swept.v[i].linear - forces.v[i].linear).norm(), 0.0, 1e-12);
        EXPECT_NEAR((swept.v[i].angular - forces.v[i].angular).norm(), 0.0, 1e-12);
    }
}

TEST(Pgs, TheMatrixIsSymmetricWithKOnItsDiagonal) {
    Problem problem;
    const GlobalRows rows =
        globalRows(problem.constraints, problem.v, Settings::seed(), support::kStep);
    const Eigen::MatrixXd a = systemMatrix(rows, 6);
    EXPECT_NEAR((a - a.transpose()).cwiseAbs().maxCoeff(), 0.0, 1e-14);
    for (int i = 0; i < rows.count(); ++i) EXPECT_NEAR(a(i, i), rows.rows[i].row.k, 1e-14);
}

/// A running world: a step from the same state by any method gives the same velocities.
TEST(Pgs, AStackFallsAlikeByEveryMethod) {
    Settings settings = Settings::seed();
    settings.bounce = Bounce::bias;
    World swept = support::stack(5, settings);
    settings.method = Method::pgs;
    World pgs = support::stack(5, settings);
    settings.method = Method::pgsMatrix;
    World matrix = support::stack(5, settings);
    for (int step = 0; step < 60; ++step)
        for (World* world : {&swept, &pgs, &matrix}) world->step(support::kStep);
    for (int i = 1; i <= 5; ++i) {
        const Vec3 at = swept.pose({i}).position;
        EXPECT_NEAR((pgs.pose({i}).position - at).norm(), 0.0, 1e-9);
        EXPECT_NEAR((matrix.pose({i}).position - at).norm(), 0.0, 1e-9);
    }
}

TEST(Pgs, CanBeSwitchedToInARunningWorld) {
    Settings settings = Settings::steady();
    World world = support::stack(5, settings);
    support::run(world, 60);
    const double height = world.pose({5}).position.y();
    for (const Method method : {Method::pgs, Method::direct, Method::pgsMatrix, Method::impulses}) {
        settings.method = method;
        world.setSettings(settings);
        support::run(world, 30);
        EXPECT_EQ(world.report().trouble, Trouble::none);
        EXPECT_NEAR(world.pose({5}).position.y(), height, 1e-3);
    }
}

}  // namespace
}  // namespace engine
