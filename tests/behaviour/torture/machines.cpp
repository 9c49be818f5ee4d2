#include <numbers>

#include "tests/behaviour/torture/worlds.h"
#include "tests/support/joints.h"

namespace torture {
namespace {

using namespace engine;
using support::Random;

BodyId add(Case& c, const Shape& shape, const Vec3& at, double mass, const Vec3& velocity) {
    BodyDef def = support::body(shape, at, mass);
    def.velocity = velocity;
    def.material.friction = 0.8;
    c.bodies.push_back(c.world.add(def));
    return c.bodies.back();
}

/// A deck on two or three axles with sprung wheels, thrown with up to 30 m/s.
void car(Case& c, Random& r, const Vec3& at) {
    const double mass = logarithmic(r, 1, 1000), wheelMass = mass * logarithmic(r, 0.01, 1);
    const Vec3 velocity = r.vector(30);
    const BodyId deck = add(c, Shape::box({2, 0.2, 1}), at, mass, velocity);
    const Motor motor{r.number(-40, 40), chance(r, 0.5) ? mass * logarithmic(r, 0.1, 10) : 0.0};
    const Spring spring{.hz = logarithmic(r, 0.5, 8), .damping = r.number(0, 1)};
    const int axles = chance(r, 0.5) ? 2 : 3;
    for (int i = 0; i < axles; ++i)
        for (const double z : {-0.7, 0.7}) {
            const Vec3 place = at + Vec3(1.6 * i / (axles - 1) - 0.8, -0.3, z);
            const Shape shape = chance(r, 0.5) ? Shape::sphere(0.3) : Shape::cylinder(0.3, 0.2);
            const BodyId wheel = add(c, shape, place, wheelMass, velocity);
            JointDef def = support::jointAt(c.world, JointType::wheel, deck, wheel, place, Vec3::UnitY(),
                                            Vec3::UnitZ());
            def.free[0].spring = spring, def.free[0].limits = {-0.1, 0.15};
            def.free[1].motor = motor;
            addJoint(c, def);
        }
}

/// Eccentric weights on pins of a frame, which falls or is held, each geared to the one before.
void gearTrain(Case& c, Random& r, const Vec3& at) {
    const bool held = chance(r, 0.5);
    const BodyId frame = held ? c.world.add(support::hook(at))
                              : add(c, Shape::box({2, 0.3, 0.1}), at, logarithmic(r, 0.1, 10), r.vector(5));
    BodyId last;
    for (int i = 0; i < 4; ++i) {
        const Vec3 pin = at + Vec3(0.5 * i - 0.75, 0, 0.3), off(r.number(-0.3, 0.3), r.number(-0.3, 0.3), 0);
        const BodyId weight = add(c, Shape::sphere(0.1), pin + off, logarithmic(r, 0.1, 10), Vec3::Zero());
        JointDef hinge = support::jointAt(c.world, JointType::hinge, frame, weight, pin);
        if (i == 0 && chance(r, 0.4)) hinge.free[0].motor = {r.number(-20, 20), logarithmic(r, 1, 100)};
        addJoint(c, hinge);
        if (i > 0) {
            JointDef gear = support::jointAt(c.world, JointType::gear, last, weight, pin);
            gear.ratio = (chance(r, 0.5) ? -1 : 1) * logarithmic(r, 0.2, 5);
            addJoint(c, gear);
        }
        last = weight;
    }
}

/// Beads on a closed curve, each with a ball on a rod.
void rail(Case& c, Random& r, const Vec3& at) {
    const BodyId hook = c.world.add(support::hook(at));
    std::vector<Vec3> path;
    const int points = 4 + static_cast<int>(r.number(0, 4));
    for (int i = 0; i < points; ++i) {
        const double u = 2 * std::numbers::pi * i / points;
        path.push_back(r.number(0.8, 1.5) * Vec3(std::cos(u), 0, std::sin(u)) + Vec3(0, r.number(-0.3, 0.3), 0));
    }
    for (int i = 0; i < 2; ++i) {
        const Vec3 place = at + path[i * points / 2];
        const BodyId bead = add(c, Shape::sphere(0.1), place, logarithmic(r, 0.1, 10), r.vector(5));
        JointDef def = support::jointAt(c.world, JointType::path, hook, bead, place);
        def.path = path, def.closed = true;
        if (chance(r, 0.3)) def.free[0].motor = {r.number(-3, 3), logarithmic(r, 1, 100)};
        addJoint(c, def);
        const Vec3 below = place - Vec3(0, 0.6, 0);
        const BodyId ball = add(c, Shape::sphere(0.1), below, logarithmic(r, 0.1, 10), r.vector(5));
        JointDef rod = support::jointAt(c.world, JointType::distance, bead, ball, below);
        rod.anchorA = rod.anchorB = Vec3::Zero(), rod.length = 0.6;
        addJoint(c, rod);
    }
}

/// Two thrown boxes, one of which looks at the other or stays parallel to it.
void pair(Case& c, Random& r, const Vec3& at) {
    const BodyId a = add(c, Shape::box({0.6, 0.3, 0.4}), at, logarithmic(r, 0.1, 10), r.vector(10));
    const Vec3 other = at + Vec3(r.number(0.8, 2), r.number(-0.2, 0.2), 0);
    const BodyId b = add(c, Shape::box({0.5, 0.2, 0.2}), other, logarithmic(r, 0.1, 10), r.vector(10));
    c.world.setVelocity(a, c.world.velocity(a), r.vector(10));
    const bool looks = chance(r, 0.5);
    JointDef def = support::jointAt(c.world, looks ? JointType::lookAt : JointType::axis, a, b, other, Vec3::UnitX());
    def.anchorA = Vec3::Zero();
    if (!looks && chance(r, 0.5)) def.free[0].limits = {-1, 1};
    if (!looks && chance(r, 0.3)) def.free[0].motor = {r.number(-10, 10), logarithmic(r, 0.1, 10)};
    if (chance(r, 0.2)) def.spring = {.hz = logarithmic(r, 0.5, 8), .damping = r.number(0, 1)};
    addJoint(c, def);
}

}  // namespace

void addMachines(Case& c, Random& r) {
    const int machines = 2 + static_cast<int>(r.number(0, 4));
    for (int i = 0; i < machines; ++i) {
        const Vec3 at(r.number(-7, 7), r.number(2, 6), r.number(-7, 7));
        const double which = r.number(0, 4);
        if (which < 1) car(c, r, at);
        else if (which < 2) gearTrain(c, r, at);
        else if (which < 3) rail(c, r, at);
        else pair(c, r, at);
    }
}

}  // namespace torture
