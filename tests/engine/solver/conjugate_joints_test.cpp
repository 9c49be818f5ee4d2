#include "engine/solver/conjugate_joints.h"

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace engine {
namespace {

/// Balls of a net, of 0.5 to 1.5 kg, with joints to their neighbours, held along one edge, with random velocities and
/// a last sub-step.
struct SmallNet {
    static constexpr int kSize = 6, kGroup = 0;

    Bodies bodies;
    std::vector<Joint> joints;
    Constraints c;
    JointTrees trees;
    ConjugateJoints conjugate;

    explicit SmallNet(double lastImpulses = 0.0) {
        support::Random random(3);
        for (int k = 0; k < kSize; ++k)
            for (int i = 0; i < kSize; ++i) {
                BodyDef def = support::body(Shape::sphere(0.1), Vec3(i, 0, k) + random.vector(0.1),
                                             0.5 * (1 + i % 3));
                if (k == 0) def.kind = BodyKind::fixed;
                else def.velocity = random.vector(1), def.spin = random.vector(1);
                const int here = bodies.count();
                addBody(bodies, def, here);
                if (i > 0 && k > 0) connect(here - 1, here);
                if (k > 0) connect(here - kSize, here);
            }
        c.jointsByGroup.sort(static_cast<int>(c.joints.size()), 1, [](int) { return kGroup; });
        c.jointsOutside.sort(static_cast<int>(c.joints.size()), 1, [](int) { return -1; });
        trees.build(c.joints, joints, bodies.inverseMasses);
        trees.prepare(kGroup, joints, bodies);
        eachJoint([&](TreeJoint<3>& joint) { joint.lambda = lastImpulses * random.vector(1); });
        trees.begin(kGroup, 1.0, bodies.velocities);
        conjugate.prepare(bodies.inverseMasses);
    }
    void connect(int a, int b) {
        Joint joint;
        joint.def.a = {a}, joint.def.b = {b};
        const Vec3 at = 0.5 * (bodies.poses[a].position + bodies.poses[b].position);
        joint.def.anchorA = bodies.poses[a].toLocal(at);
        joint.def.anchorB = bodies.poses[b].toLocal(at);
        JointConstraint row;
        row.a = a, row.b = b, row.joint = static_cast<int>(joints.size());
        row.count = rowCount(joint.def), row.treeRows = treeRowsOf(joint.def);
        joints.push_back(joint);
        c.joints.push_back(row);
    }
    template <class Visit>
    void eachJoint(const Visit& visit) {
        trees.eachJoint(kGroup, [&]<int N>(TreeJoint<N>& joint, const InverseMass&, const InverseMass&) {
            if constexpr (N == 3) visit(joint);
        });
    }
    void sweep() {
        Correction unused;
        trees.solveVelocities(kGroup, bodies.velocities, unused);
    }
    void sweepOn(int count) {
        conjugate.begin(c, trees, kGroup, bodies.velocities);
        for (int i = 0; i < count; ++i) {
            sweep();
            conjugate.goOn(c, trees, kGroup, bodies.velocities);
        }
    }
    /// m/s: largest |J v + gamma lambda|.
    double residual() {
        double most = 0.0;
        eachJoint([&](TreeJoint<3>& joint) {
            const TreeRows<3> left =
                velocityAlong(joint, bodies.velocities[joint.a], bodies.velocities[joint.b]) +
                joint.softness.cwiseProduct(joint.lambda);
            most = larger(most, left.cwiseAbs().maxCoeff());
        });
        return most;
    }
    /// J: kinetic energy, and what the softness takes.
    double objective() {
        double sum = 0.0;
        for (int i = 0; i < bodies.count(); ++i) {
            if (!bodies.isDynamic(i)) continue;
            const Velocity& v = bodies.velocities[i];
            const BodyMass& mass = bodies.masses[i];
            sum += mass.mass * v.linear.squaredNorm() / 2;
            sum += v.angular.dot(bodies.inverseMasses[i].angular.inverse() * v.angular) / 2;
        }
        eachJoint([&](TreeJoint<3>& joint) {
            sum += joint.lambda.dot(joint.softness.cwiseProduct(joint.lambda)) / 2;
        });
        return sum;
    }
};

TEST(ConjugateJoints, SatisfyANetThatSweepsDoNot) {
    SmallNet swept, net;
    for (int i = 0; i < 400; ++i) swept.sweep();
    net.sweepOn(200);  // there and back: as many
    EXPECT_GT(swept.residual(), 0.01);
    EXPECT_LT(net.residual(), 1e-6);
}

// Nor do many after the last that reduces it: errors of rounding must not add up.
TEST(ConjugateJoints, NoStepIncreasesTheEnergy) {
    SmallNet net;
    double before = net.objective();
    net.conjugate.begin(net.c, net.trees, SmallNet::kGroup, net.bodies.velocities);
    for (int i = 0; i < 400; ++i) {
        net.sweep();
        net.conjugate.goOn(net.c, net.trees, SmallNet::kGroup, net.bodies.velocities);
        EXPECT_LE(net.objective(), before * (1.0 + 1e-11)) << i;
        before = smaller(before, net.objective());
    }
}

TEST(ConjugateJoints, LastImpulsesThatOnlyAddEnergyAreNotKept) {
    SmallNet fresh, net(1e4);
    EXPECT_GT(net.objective(), 1e6 * fresh.objective());
    net.sweepOn(1);
    EXPECT_LT(net.objective(), fresh.objective());
}

TEST(ConjugateJoints, LeadToTheSameVelocitiesFromAnyLastImpulses) {
    SmallNet fresh, net(1.0);
    fresh.sweepOn(300), net.sweepOn(300);
    for (int i = 0; i < net.bodies.count(); ++i) {
        const Velocity &a = net.bodies.velocities[i], &b = fresh.bodies.velocities[i];
        EXPECT_LT((a.linear - b.linear).norm() + (a.angular - b.angular).norm(), 1e-5) << i;
    }
}

// Without it, impulses along what the bodies can hardly move in grow without bound.
TEST(JointTrees, OnlyRowsOfANetAreSoft) {
    SmallNet net;
    net.eachJoint([](TreeJoint<3>& joint) { EXPECT_GT(joint.softness.minCoeff(), 0.0); });
    SmallNet chain;
    chain.joints.clear(), chain.c.joints.clear();
    for (int k = 1; k < SmallNet::kSize; ++k) chain.connect((k - 1) * SmallNet::kSize, k * SmallNet::kSize);
    chain.trees.build(chain.c.joints, chain.joints, chain.bodies.inverseMasses);
    chain.trees.sortInto(1, [](int, int) { return SmallNet::kGroup; });
    chain.trees.prepare(0, chain.joints, chain.bodies);
    int count = 0;
    chain.eachJoint([&](TreeJoint<3>& joint) {
        EXPECT_EQ(joint.softness, TreeRows<3>::Zero());
        ++count;
    });
    EXPECT_EQ(count, SmallNet::kSize - 1);
}

}  // namespace
}  // namespace engine
