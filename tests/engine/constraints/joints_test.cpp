// mission 12: for every type J v equals the central difference of C at 100 random states.
#include <gtest/gtest.h>

#include <string>

#include "engine/constraints/catmull_rom.h"
#include "engine/constraints/joint_constraint.h"
#include "engine/dynamics/rotation.h"
#include "tests/support/joints.h"

namespace engine {
namespace {

constexpr JointType kAll[] = {
    JointType::ball,     JointType::distance,         JointType::hinge,  JointType::weld,
    JointType::slider,   JointType::universal,        JointType::constantVelocity,
    JointType::lookAt,   JointType::axis,             JointType::sixDof, JointType::gear,
    JointType::wheel};

/// Two moving bodies, and a joint far from satisfied.
struct State {
    Joint joint;
    Pose a, b;
    Velocity va, vb;

    State(JointType type, support::Random& random) {
        joint.def.type = type;
        joint.def.anchorA = random.vector(1), joint.def.anchorB = random.vector(1);
        joint.def.length = 0.7;
        joint.def.ratio = -1.7;
        joint.axisA = random.vector(1).normalized(), joint.axisB = random.vector(1).normalized();
        joint.turnAtStart = random.rotation();
        joint.axis2B = random.vector(1).normalized();
        joint.axis2A = joint.axisA.cross(random.vector(1)).normalized();
        joint.startA = random.rotation(), joint.startB = random.rotation();
        for (Freedom& freedom : joint.def.free) freedom.locked = type == JointType::sixDof;
        a = {random.vector(2), random.rotation()}, b = {random.vector(2), random.rotation()};
        va = {random.vector(2), random.vector(2)}, vb = {random.vector(2), random.vector(2)};
    }
    static Pose moved(const Pose& pose, const Velocity& v, double t) {
        return {pose.position + t * v.linear, cayley(t * v.angular, pose.rotation)};
    }
    JointRows rows(double t) const {
        return rowsOf(joint.def.type, geometryOf(joint, moved(a, va, t), moved(b, vb, t)));
    }
    JointRows coordinates(double t) const {
        return coordinatesOf(joint, moved(a, va, t), moved(b, vb, t));
    }
};

/// J v against the central difference of C; angles may jump by full turns in between.
template <class At>
void expectDerivative(const State& state, At at) {
    const double dt = 1e-5;
    const JointRows now = at(0.0), before = at(-dt), after = at(dt);
    for (int k = 0; k < now.count; ++k) {
        const double change = after.error[k] - before.error[k];
        const double slope = change / (2 * dt);
        if (std::abs(change) > 3.0) continue;
        EXPECT_NEAR(velocityAlong(now.j[k], state.va, state.vb), slope,
                    1e-6 * larger(1.0, std::abs(slope)))
            << "row " << k;
    }
}

class EveryJoint : public testing::TestWithParam<JointType> {};

TEST_P(EveryJoint, JvIsTheDerivativeOfC) {
    support::Random random(20 + static_cast<int>(GetParam()));
    for (int i = 0; i < 100; ++i) {
        const State state(GetParam(), random);
        expectDerivative(state, [&](double t) { return state.rows(t); });
    }
}

TEST_P(EveryJoint, JvIsTheRateOfItsCoordinates) {
    support::Random random(60 + static_cast<int>(GetParam()));
    for (int i = 0; i < 100; ++i) {
        const State state(GetParam(), random);
        expectDerivative(state, [&](double t) { return state.coordinates(t); });
    }
}

TEST_P(EveryJoint, JvIsTheRateOfWhatASpringPulls) {
    support::Random random(90 + static_cast<int>(GetParam()));
    for (int i = 0; i < 100; ++i) {
        const State state(GetParam(), random);
        const auto faded = [](JointRows rows, double rest) {
            for (int k = 0; k < rows.count; ++k) rows.fade(k, rest);
            return rows;
        };
        expectDerivative(state, [&](double t) { return faded(state.coordinates(t), 0.4); });
        expectDerivative(state, [&](double t) { return faded(state.rows(t), 0.0); });
    }
}

// Where the twist is undefined, its rate has no bound.
TEST(Twist, PullsASpringWithABoundedLever) {
    support::Random random(7);
    for (const double left : {1e-2, 1e-5, 1e-9}) {
        const Vec3 h = random.vector(1).normalized(), across = h.cross(random.vector(1)).normalized();
        const double half = 0.5 * (kPi - left);
        Quat turn(cosine(half), 0, 0, 0);
        turn.vec() = sine(half) * across;
        JointRows rows;
        addTurn(twistAbout(h, turn), rows);
        EXPECT_GT(rows.j[0].angularB.norm(), 1.0 / left);
        rows.fade(0);
        EXPECT_LT(rows.j[0].angularB.norm(), 3.0);
        EXPECT_LT(std::abs(rows.error[0]), left * kPi);
    }
}

TEST_P(EveryJoint, HasNoErrorWhereItWasMade) {
    support::Random random(30);
    World world;
    const BodyId a = world.add(support::body(Shape::sphere(0.5), random.vector(1)));
    BodyDef other = support::body(Shape::sphere(0.5), random.vector(1));
    other.pose.rotation = random.rotation();
    const BodyId b = world.add(other);
    JointDef def = support::jointAt(world, GetParam(), a, b, {0.1, 0.2, 0.3}, {0, 0, 1}, {1, 0, 0});
    if (GetParam() == JointType::distance) {
        def.length = (world.pose(b).position - world.pose(a).position).norm();
        def.anchorA = def.anchorB = Vec3::Zero();
    }
    const JointState state = world.joint(world.add(def));
    EXPECT_LT(state.separation, 1e-15);
    if (GetParam() != JointType::distance && GetParam() != JointType::constantVelocity) {
        EXPECT_NEAR(state.position, 0.0, 1e-14);
    }
}

std::string nameOf(const testing::TestParamInfo<JointType>& one) {
    constexpr const char* kNames[] = {"ball",      "distance",         "hinge",  "weld", "slider",
                                      "universal", "constantVelocity", "lookAt", "axis", "sixDof",
                                      "gear",      "wheel",            "path"};
    return kNames[static_cast<int>(one.param)];
}

INSTANTIATE_TEST_SUITE_P(All, EveryJoint, testing::ValuesIn(kAll), nameOf);

// On the curve; off it, the rows are constant while the nearest point moves.
TEST(PathJoint, JvIsTheDerivativeOfCOnTheCurve) {
    support::Random random(33);
    for (int i = 0; i < 100; ++i) {
        State state(JointType::path, random);
        for (int k = 0; k < 5; ++k)
            state.joint.def.path.push_back(Vec3(1.0 * k, 0, 0) + random.vector(0.4));
        state.joint.lengths.assign(5, 0.0);
        const double t = random.number(0.1, 3.9);
        state.joint.nearest = t;
        const Vec3 at = state.a.toWorld(curveAt(state.joint.def.path, false, t).at);
        state.b.position = at - state.b.rotation * state.joint.def.anchorB;
        const JointRows now = state.rows(0.0);
        const double dt = 1e-6;
        const JointGeometry g = geometryOf(state.joint, state.a, state.b);
        for (int k = 0; k < 2; ++k) {
            EXPECT_NEAR(now.error[k], 0.0, 1e-12);
            const auto error = [&](double when) {  // along the row's direction as it turns with a
                const Pose a = State::moved(state.a, state.va, when);
                const Pose b = State::moved(state.b, state.vb, when);
                const JointGeometry then = geometryOf(state.joint, a, b);
                const Vec3 held = a.rotation * (state.a.rotation.conjugate() * g.acrossPath[k]);
                return held.dot(then.fromPath);
            };
            EXPECT_NEAR(velocityAlong(now.j[k], state.va, state.vb),
                        (error(dt) - error(-dt)) / (2 * dt), 1e-4);
        }
    }
}

TEST(Joints, CountTheirRows) {
    const auto count = [](JointType type) {
        return rowsOf(type, geometryOf(Joint{}, Pose{}, Pose{})).count;
    };
    for (const JointType type : kAll)
        EXPECT_EQ(count(type), type == JointType::sixDof ? 0 : rowCount(type));
    EXPECT_EQ(count(JointType::ball), 3);
    EXPECT_EQ(count(JointType::distance), 1);
    EXPECT_EQ(count(JointType::hinge), 5);
    EXPECT_EQ(count(JointType::weld), 6);
}

// mission 14: p = (3,4,0), p0 = 0, l = 4: C = 1
TEST(DistanceJoint, IsTheDistanceLessTheLength) {
    Joint joint;
    joint.def.type = JointType::distance;
    joint.def.length = 4.0;
    const JointRows rows =
        rowsOf(JointType::distance, geometryOf(joint, {}, {{3, 4, 0}, Quat::Identity()}));
    EXPECT_NEAR(rows.error[0], 1.0, 1e-15);
    EXPECT_LT((rows.j[0].linear - Vec3(0.6, 0.8, 0)).norm(), 1e-15);  // unit(p - p0)
}

// The same with r = (0, -0.5, 0), I = 0.4, m = 2, v = (1, 2, 3), w = (0, 0, 1), by the joint's row.
TEST(DistanceJoint, GivesTheSeedsImpulseAtAnArm) {
    Joint joint;
    joint.def.type = JointType::distance;
    joint.def.length = 4.0;
    joint.def.anchorB = {0, -0.5, 0};
    const JointRows rows =
        rowsOf(JointType::distance, geometryOf(joint, {}, {{3, 4.5, 0}, Quat::Identity()}));
    const Row row = makeRow(rows.j[0], {}, {0.5, Mat3::Identity() / 0.4});
    EXPECT_NEAR(rows.error[0], 1.0, 1e-15);
    EXPECT_NEAR(row.k, 0.725, 1e-15);
    EXPECT_NEAR(correctiveImpulse(row, 0.0, {}, {{1, 2, 3}, {0, 0, 1}}), -3.4482759, 5e-8);
}

}  // namespace
}  // namespace engine
