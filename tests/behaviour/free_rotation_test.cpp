// A free body compared with the closed solution of Euler's equations in Jacobi's functions (Landau and
// Lifshitz, Mechanics, section 37), from needles to plates, up to 200 rad/s.
#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace engine {
namespace {

/// sn, cn and dn of u, by the arithmetic-geometric mean (Abramowitz and Stegun, 16.4); m1 = 1 - k^2.
struct Jacobi {
    double sn, cn, dn;

    Jacobi(double u, double m1) {
        double a[20] = {1.0}, c[20] = {std::sqrt(1.0 - m1)}, b = std::sqrt(m1);
        int n = 0;
        for (; n < 19 && c[n] > 1e-17; ++n) {
            a[n + 1] = 0.5 * (a[n] + b);
            c[n + 1] = 0.5 * (a[n] - b);
            b = std::sqrt(a[n] * b);
        }
        const double period = 2.0 * kCircle / a[n];  // 4 K
        double phi = std::ldexp(a[n] * std::remainder(u, period), n);
        for (; n > 0; --n) phi = 0.5 * (phi + std::asin(c[n] / a[n] * std::sin(phi)));
        sn = std::sin(phi), cn = std::cos(phi);
        dn = std::sqrt(cn * cn + m1 * sn * sn);
    }
    static constexpr double kCircle = 3.14159265358979323846;
};

/// Moments I1 < I2 < I3, the spin (W1, 0, W3) at the start, L above the middle axis: L^2 > 2 E I2.
struct Closed {
    Vec3 inertia, spin;
    double rate, m1;

    Closed(const Vec3& moments, const Vec3& start) : inertia(moments), spin(start) {
        const double i1 = inertia[0], i2 = inertia[1], i3 = inertia[2];
        const double a = i1 * spin[0] * spin[0], c = i3 * spin[2] * spin[2];
        // L^2 - 2 E I1 and so on, without differences of nearly equal numbers
        const double over1 = c * (i3 - i1), over2 = c * (i3 - i2) - a * (i2 - i1);
        rate = std::sqrt((i3 - i2) * over1 / (i1 * i2 * i3));
        m1 = (i3 - i1) * over2 / ((i3 - i2) * over1);
    }
    Vec3 spinAt(double t) const {
        const Jacobi f(rate * t, m1);
        const double i1 = inertia[0], i2 = inertia[1], i3 = inertia[2];
        return {spin[0] * f.cn, spin[0] * std::sqrt(i1 * (i3 - i1) / (i2 * (i3 - i2))) * f.sn,
                spin[2] * f.dn};
    }
    Vec3 momentumAt(double t) const { return inertia.cwiseProduct(spinAt(t)); }
    double precession(double t) const {  // rad/s of the body's first axis about L
        const Vec3 l = momentumAt(t), w = spinAt(t);
        return l.norm() * (l[1] * w[1] + l[2] * w[2]) / (l[1] * l[1] + l[2] * l[2]);
    }
    /// L is along the world's x axis: psi and theta follow from L in body axes, phi is the integral of its
    /// rate, by Simpson's rule.
    Quat rotationAt(double t) const {
        const Vec3 l = momentumAt(t);
        const int cuts = 2 * static_cast<int>(200.0 * (1.0 + t * spin.norm()));
        double phi = precession(0.0) + precession(t);
        for (int i = 1; i < cuts; ++i) phi += (i % 2 ? 4.0 : 2.0) * precession(t * i / cuts);
        phi *= t / cuts / 3.0;
        const Quat psi(Eigen::AngleAxisd(std::atan2(l[1], l[2]), Vec3::UnitX()));
        const Quat theta(Eigen::AngleAxisd(std::acos(l[0] / l.norm()), Vec3::UnitY()));
        return Quat(Eigen::AngleAxisd(phi, Vec3::UnitX())) * theta * psi;
    }
};

struct Flight {
    double aspect, spin;
};

class FreeRotation : public testing::TestWithParam<Flight> {
protected:
    static Vec3 sizes() {  // x the longest: I1 < I2 < I3 of x, y, z
        const double aspect = GetParam().aspect;
        return {1.0, aspect > 1.0 ? 1.3 / aspect : 1.0, 1.0 / aspect};
    }
    static Vec3 moments() {
        const Vec3 d = sizes().cwiseProduct(sizes());
        return Vec3(d[1] + d[2], d[0] + d[2], d[0] + d[1]) / 12.0;
    }
    /// Rotation about the middle axis except for a thousandth, most of the time: the case in which errors
    /// grow fastest. Between two flips the middle component is 0; the motion starts there.
    static Closed motion() {
        const Vec3 i = moments();
        const double w = GetParam().spin;
        const double w1 = w * std::sqrt(i[1] * (i[2] - i[1]) / (i[0] * (i[2] - i[0])));
        const double w3 = w * std::sqrt(i[1] * (i[1] - i[0]) / (i[2] * (i[2] - i[0])));
        return {i, {w1, 0.0, 1.001 * w3}};
    }
    static World fly(const Settings& settings, BodyId& id) {
        World world(settings);
        world.setGravity(Vec3::Zero());
        BodyDef box = support::body(Shape::box(sizes()), Vec3::Zero());
        const Closed closed = motion();
        box.inertia = Mat3(closed.inertia.asDiagonal());
        box.pose.rotation = closed.rotationAt(0.0);
        box.spin = box.pose.rotation * closed.spin;
        id = world.add(box);
        return world;
    }
};

INSTANTIATE_TEST_SUITE_P(Shapes, FreeRotation,
                         testing::Values(Flight{2, 1}, Flight{2, 200}, Flight{8, 50}, Flight{30, 20},
                                         Flight{100, 3}, Flight{100, 200}),
                         [](const auto& one) {
                             return "Aspect" + std::to_string(int(one.param.aspect)) + "Spin" +
                                    std::to_string(int(one.param.spin));
                         });

TEST_P(FreeRotation, FollowsJacobisFunctions) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        BodyId id;
        World world = fly(settings, id);
        support::run(world, 600);
        const Quat closed = motion().rotationAt(10.0);
        EXPECT_LT(closed.angularDistance(world.pose(id).rotation), 1e-2);
    }
}

TEST_P(FreeRotation, KeepsEnergyAndMomentumForAMinute) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        BodyId id;
        World world = fly(settings, id);
        const auto momentum = [&] {
            const Quat& q = world.pose(id).rotation;
            return Vec3(q * Vec3(world.inertia(id) * Vec3(q.conjugate() * world.spin(id))));
        };
        const double energy = world.energy().kinetic;
        const Vec3 before = momentum();
        for (int i = 0; i < 3600; ++i) {
            ASSERT_TRUE(world.step(support::kStep)) << i;
            ASSERT_NEAR(world.energy().kinetic / energy, 1.0, 1e-8) << i;
        }
        EXPECT_LT((momentum() - before).norm(), 1e-9 * before.norm());
    }
}

// The only bound of the spin is the engine's own: a needle and a ball near 1e4 rad/s.
TEST(FastSpin, TurnsAsFarAsItsSpinSaysAtAnySpeed) {
    World world;
    world.setGravity(Vec3::Zero());
    BodyDef ball = support::body(Shape::sphere(0.1), Vec3::Zero());
    BodyDef needle = support::body(Shape::box({1.0, 0.01, 0.01}), {5, 0, 0});
    ball.spin = needle.spin = {0, 0, 9500.0};
    const BodyId a = world.add(ball), b = world.add(needle);
    support::run(world, 60);
    const Quat turned(Eigen::AngleAxisd(9500.0, Vec3::UnitZ()));
    EXPECT_LT(turned.angularDistance(world.pose(a).rotation), 1e-6);
    EXPECT_LT(turned.angularDistance(world.pose(b).rotation), 1e-6);
    EXPECT_NEAR(world.spin(b).z(), 9500.0, 1e-6);
}

}  // namespace
}  // namespace engine
