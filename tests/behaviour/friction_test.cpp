// mission 33: Coulomb friction on an incline, against closed forms.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::kGravity;
using support::kStep;
using support::run;

/// Contacts as rows in double precision, and eight side by side in single precision; the accuracy of each,
/// m/s^2.
struct Form {
    bool lanes;
    double exact;
};
constexpr Form kForms[] = {{false, 1e-8}, {true, 5e-6}};

Settings settingsOf(const Form& form) {
    Settings settings = Settings::steady();
    settings.lanes = form.lanes;
    return settings;
}

/// A plane inclined by the angle, down towards +x, and a body on it.
struct Incline {
    World world;
    BodyId rider;
    Vec3 downhill;

    Incline(double degrees, double mu, const Shape& shape, double height,
            const Form& form = kForms[1])
        : world(settingsOf(form)) {
        const double a = radians(degrees);
        const Vec3 normal(sine(a), cosine(a), 0);
        downhill = Vec3(cosine(a), -sine(a), 0);
        BodyDef plane = support::fixed(Shape::plane(normal));
        plane.material.friction = mu;
        world.add(plane);
        BodyDef def = body(shape, height * normal, 2.0);
        def.pose.rotation = turnAbout(Vec3::UnitZ(), -a);
        def.material.friction = mu;
        rider = world.add(def);
    }
    double way() const { return world.pose(rider).position.dot(downhill); }
    double speed() const { return world.velocity(rider).dot(downhill); }
};

/// m/s^2 downhill, during the second second; the first includes the landing.
double acceleration(Incline& incline) {
    run(incline.world, 60);
    const double before = incline.speed();
    run(incline.world, 60);
    return incline.speed() - before;
}

// g (sin 30 deg - mu cos 30 deg) = 2.356287 m/s^2 for mu = .3
TEST(Incline, ABoxSlidesWithGSinLessMuCos) {
    for (const Form& form : kForms) {
        Incline incline(30, 0.3, Shape::box({1, 1, 1}), 0.5, form);
        const double measured = acceleration(incline);
        EXPECT_NEAR(measured, 2.356287, 5e-7);
        EXPECT_NEAR(measured, kGravity * (0.5 - 0.3 * std::sqrt(0.75)), form.exact);
    }
}

TEST(Incline, ABoxHoldsWhereMuIsEnough) {
    Incline incline(30, 0.6, Shape::box({1, 1, 1}), 0.5);
    run(incline.world, 600);
    EXPECT_LT(std::abs(incline.way()), 1e-3);
}

// 5/7 g sin while mu >= 2/7 tan 30 deg = 0.165: it rolls
TEST(Incline, ASphereRollsWithFiveSevenths) {
    for (const Form& form : kForms)
        for (const double mu : {0.5, 0.17}) {
            Incline incline(30, mu, Shape::sphere(0.5), 0.5, form);
            EXPECT_NEAR(acceleration(incline), 5.0 / 7.0 * kGravity * 0.5, form.exact) << mu;
            EXPECT_NEAR(-incline.world.spin(incline.rider).z() * 0.5, incline.speed(), form.exact)
                << mu;
        }
}

// Below that it slips, like the box.
TEST(Incline, ASphereSlipsOnIce) {
    for (const Form& form : kForms)
        for (const double mu : {0.1, 0.16}) {
            Incline incline(30, mu, Shape::sphere(0.5), 0.5, form);
            const double expected = kGravity * (0.5 - mu * std::sqrt(0.75));
            EXPECT_NEAR(acceleration(incline), expected, form.exact) << mu;
            EXPECT_LT(-incline.world.spin(incline.rider).z() * 0.5, incline.speed() - 0.1) << mu;
        }
}

TEST(Friction, StopsInTheSameDistanceInEveryDirection) {
    double shortest = 1e9, longest = 0.0;
    for (int degrees = 0; degrees < 90; degrees += 15) {
        World world;
        BodyDef plane = support::floorPlane();
        plane.material.friction = 0.4;
        world.add(plane);
        BodyDef box = body(Shape::box({1, 0.2, 1}), {0, 0.1, 0}, 3.0);
        box.material.friction = 0.4;
        const double a = radians(degrees);
        box.velocity = Vec3(4 * cosine(a), 0, 4 * sine(a));
        const BodyId id = world.add(box);
        run(world, 120);
        EXPECT_LT(world.velocity(id).norm(), 1e-3);
        const Vec3 way = world.pose(id).position - box.pose.position;
        const double distance = std::hypot(way.x(), way.z());
        shortest = smaller(shortest, distance), longest = larger(longest, distance);
        EXPECT_NEAR(distance, 16 / (2 * 0.4 * kGravity), 0.02);  // v^2 / (2 mu g)
    }
    EXPECT_LT(longest / shortest, 1.01);
}

}  // namespace
}  // namespace engine
