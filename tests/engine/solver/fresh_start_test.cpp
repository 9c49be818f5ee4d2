// Islands whose kept impulses bring energy (solver/fresh_start.h), in lanes and in rows.
#include "engine/solver/fresh_start.h"

#include <gtest/gtest.h>

#include "engine/solver/impulses.h"
#include "engine/solver/paces.h"
#include "engine/solver/prepare_contacts.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

/// Balls of 1 kg and 0.5 m, each on a platform of its own that rises at 2 m/s.
struct Lifts {
    Bodies bodies;
    std::vector<Contact> contacts;
    Solver solver;
    Settings settings;

    /// A ball with this velocity relative to its platform, which has kept an impulse along y. Returns the
    /// contact.
    Contact& add(const Velocity& v, double kept) {
        const int platform = bodies.count(), ball = platform + 1;
        const double x = 3.0 * platform;
        BodyDef def = support::body(Shape::box({1, 1, 1}), {x, 0, 0});
        def.kind = BodyKind::kinematic;
        def.mass.reset();
        def.velocity = {0, 2, 0};
        addBody(bodies, def, platform);
        addBody(bodies, support::body(Shape::sphere(0.5), {x, 1, 0}), ball);
        bodies.velocities[ball] = {v.linear + def.velocity, v.angular};
        Contact contact;
        contact.a = platform, contact.b = ball, contact.count = 1;
        contact.normal = Vec3::UnitY();
        contact.friction = 1.0, contact.rolling = 1.0;
        contact.points[0].anchorA = {0, 0.5, 0}, contact.points[0].anchorB = {0, -0.5, 0};
        contact.points[0].impulse = kept;
        contacts.push_back(contact);
        return contacts.back();
    }

    /// Starts from the kept impulses, and takes back those that bring energy.
    bool takesBack(bool lanes) {
        settings.lanes = lanes;
        setSpans(bodies, support::kStep);
        connect(contacts, {}, bodies, solver.islands);
        orderContacts(contacts, bodies, Vec3(0, -1, 0), Order::gravity, solver.keys, solver.order);
        prepareContacts(contacts, {}, bodies, settings, solver);
        updateSeparations(bodies, solver);
        std::vector<Velocity>& v = bodies.velocities;
        if (!lanes) {
            beginSolving(solver.constraints, v, settings, support::kStep);
            warmStart(solver.constraints, v, settings);
            return solver.fresh.takeBack(solver.constraints, solver.constraints.order, solver.groups, v);
        }
        solver.wide.begin(v, settings);
        solver.wide.warmStart(0);
        const bool any = solver.wide.takeBack(0);
        solver.wide.finish(v);
        return any;
    }
    const Velocity& ball(int i) const { return bodies.velocities[2 * i + 1]; }
    PointImpulses kept(int i) const { return impulsesOf(solver, i, 0); }
};

const Velocity kFalling{{0, -3, 0}, {0, 0, 0}};

class FreshStarts : public testing::TestWithParam<bool> {};

// f = -3 m/s lambda + lambda^2 / 2 kg: positive from 6 N s on. With 5.9 N s the ball gains energy, but from the
// platform.
TEST_P(FreshStarts, ForgetImpulsesThatThrowABodyFromItsSupport) {
    for (const double kept : {0.5, 5.9, 6.1, 1e4}) {
        Lifts lifts;
        lifts.add(kFalling, kept);
        const bool tooMuch = kept > 6.0;
        EXPECT_EQ(lifts.takesBack(GetParam()), tooMuch) << kept;
        EXPECT_NEAR(lifts.ball(0).linear.y(), tooMuch ? -1.0 : kept - 1.0, 1e-6) << kept;
        EXPECT_NEAR(lifts.kept(0).normal, tooMuch ? 0.0 : kept, 1e-6) << kept;
    }
}

// A gap of 3 cm may close within the step, at 1.8 m/s: f = -1.2 m/s lambda + lambda^2 / 2 kg.
TEST_P(FreshStarts, CountTheBiasOfAGap) {
    for (const double kept : {2.3, 2.5}) {
        Lifts lifts;
        lifts.add(kFalling, kept);
        lifts.bodies.poses[1].position.y() += 0.03;
        EXPECT_EQ(lifts.takesBack(GetParam()), kept > 2.4) << kept;
    }
}

// Friction F against 3 m/s of slip acts on 1 / (1 / m + r^2 / I) = 2/7 kg: too much from 12/7 N s on. It is at 45
// degrees, so that both tangents count.
TEST_P(FreshStarts, CountFriction) {
    const Vec3 way = Vec3(1, 0, 1).normalized();
    for (const double kept : {1.70, 1.73}) {
        Lifts lifts;
        lifts.add({3.0 * way, Vec3::Zero()}, 0.0).points[0].friction = -kept * way;
        const bool tooMuch = kept > 12.0 / 7.0;
        EXPECT_EQ(lifts.takesBack(GetParam()), tooMuch) << kept;
        EXPECT_NEAR(lifts.ball(0).linear.dot(way), tooMuch ? 3.0 : 3.0 - kept, 1e-6) << kept;
        EXPECT_NEAR(lifts.kept(0).friction.norm(), tooMuch ? 0.0 : kept, 1e-6) << kept;
    }
}

// A moment M against 4 rad/s, I = 0.1 kg m^2: too much from 0.8 N m s on. The slip of the surface, 2 m/s, has no
// impulse.
TEST_P(FreshStarts, CountRollingResistance) {
    const Vec3 axis = Vec3(1, 0, 1).normalized();
    for (const double kept : {0.79, 0.81}) {
        Lifts lifts;
        lifts.add({Vec3::Zero(), 4.0 * axis}, 0.0).rollingMoment = -kept * axis;
        const bool tooMuch = kept > 0.8;
        EXPECT_EQ(lifts.takesBack(GetParam()), tooMuch) << kept;
        EXPECT_NEAR(lifts.ball(0).angular.dot(axis), tooMuch ? 4.0 : 4.0 - 10.0 * kept, 1e-5) << kept;
        storeImpulses(lifts.solver, lifts.contacts);
        EXPECT_NEAR(lifts.contacts[0].rollingMoment.norm(), tooMuch ? 0.0 : kept, 1e-6) << kept;
    }
}

TEST_P(FreshStarts, LeaveOtherIslandsTheirImpulses) {
    Lifts lifts;
    for (const double kept : {3.0, 7.0, 4.0}) lifts.add(kFalling, kept);
    EXPECT_TRUE(lifts.takesBack(GetParam()));
    EXPECT_EQ(lifts.kept(0).normal, 3.0);
    EXPECT_EQ(lifts.kept(1).normal, 0.0);
    EXPECT_EQ(lifts.kept(2).normal, 4.0);
    EXPECT_EQ(lifts.ball(0).linear.y(), 2.0);
    EXPECT_EQ(lifts.ball(1).linear.y(), -1.0);
    EXPECT_EQ(lifts.ball(2).linear.y(), 3.0);
}

INSTANTIATE_TEST_SUITE_P(Contacts, FreshStarts, testing::Bool(),
                         [](const auto& lanes) { return lanes.param ? "InLanes" : "InRows"; });

}  // namespace
}  // namespace engine
