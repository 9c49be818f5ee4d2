#include <algorithm>
#include <cmath>

#include "tests/benchmark/peer_parts.h"

namespace peers {

namespace {

/// Joints only: nothing collides, so there is nothing to penetrate.
Scene jointScene() {
    Scene scene;
    scene.watchPenetration = false;
    return scene;
}

/// A tower: does it stand when the solver has too few sweeps for its height?
Scene stack(int cubes) {
    Scene scene;
    scene.shouldStand = true;
    addFloor(scene);
    for (int i = 0; i < cubes; ++i) add(scene, cube({0, i + 0.5, 0}));
    return scene;
}

/// Twenty rows of bricks, half a brick at the ends of every second row.
Scene wall() {
    Scene scene;
    scene.shouldStand = true;
    addFloor(scene);
    for (int row = 0; row < 20; ++row) {
        const double y = row + 0.5;
        if (row % 2 == 0) {
            for (int i = 0; i < 20; ++i) add(scene, cube({i - 9.5, y, 0}));
        } else {
            add(scene, box({.25, .5, .5}, {-9.75, y, 0}));
            for (int i = 0; i < 19; ++i) add(scene, cube({i - 9.0, y, 0}));
            add(scene, box({.25, .5, .5}, {9.75, y, 0}));
        }
    }
    return scene;
}

/// A ball of 1000 kg on twenty links of 1 kg, hanging or released level: a mass ratio that sweeps
/// from row to row hardly resolve.
Scene heavyBall(bool level) {
    Scene scene = jointScene();
    scene.watchEnergy = level;
    const int links = 20;
    const double length = 0.5, radius = 0.5;
    const double linkDensity = 1.0 / (8 * .25 * .05 * .05);
    const double ballDensity = 1000.0 / (4.0 / 3 * kPi * radius * radius * radius);
    const auto along = [&](double s) { return level ? Vec3(s, 0, 0) : Vec3(0, -s, 0); };
    const Vec3 halfSize = level ? Vec3(.25, .05, .05) : Vec3(.05, .25, .05);
    int previous = add(scene, ghost(fixed(sphere(0.05, {0, 0, 0}))));
    for (int i = 0; i < links; ++i) {
        const int link = add(scene, ghost(box(halfSize, along(length * (i + 0.5)), linkDensity)));
        addBall(scene, previous, link, along(length * i));
        previous = link;
    }
    const Body ball = sphere(radius, along(length * links + radius), ballDensity);
    addBall(scene, previous, add(scene, ghost(ball)), along(length * links));
    scene.energyScale = 1000 * kGravity * (length * links + radius);
    return scene;
}

constexpr double kBridgeRadius = 100.0;  // m, of the arc

Vec3 onBridge(double angle) {
    const double r = kBridgeRadius;
    return {r * std::sin(angle), -r * std::cos(angle) + r + 20, 0};
}

/// A hundred hinged planks between two banks, slack on an arc, and ten boxes of 1 t dropped on
/// them: joints and contacts that depend on each other.
Scene bridge() {
    Scene scene;
    scene.lostBelow = -20.0;  // far below any sag: bodies that leave the bridge fall for ever
    const int planks = 100;
    const double plank = 2 * std::asin(0.5 / kBridgeRadius);  // rad, of the arc
    const double start = -0.5 * planks * plank;
    const Vec3 left = onBridge(start), right = onBridge(start + planks * plank);
    int previous = add(scene, fixed(box({.5, .5, 1.0}, {left.x() - 0.5, left.y(), 0})));
    const int bank = add(scene, fixed(box({.5, .5, 1.0}, {right.x() + 0.5, right.y(), 0})));
    for (int i = 0; i < planks; ++i) {
        const double angle = start + i * plank;
        const Vec3 from = onBridge(angle), to = onBridge(angle + plank);
        Body body = box({.5, .1, 1.0}, 0.5 * (from + to));
        body.pose.rotation = turn({0, 0, 1}, std::atan2(to.y() - from.y(), to.x() - from.x()));
        const int next = add(scene, body);
        addHinge(scene, previous, next, from);
        if (i == planks - 1) addHinge(scene, next, bank, to);
        previous = next;
    }
    for (int i = 0; i < 10; ++i) {
        const Vec3 at = onBridge((i - 4.5) * 4 * plank);
        add(scene, cube({at.x(), at.y() + 1.2, 0}));
    }
    return scene;
}

/// Four walls around a floor of 13 m by 13 m.
void addBin(Scene& scene) {
    const double half = 6.5, height = 30;
    addFloor(scene);
    add(scene, fixed(box({.5, height, half + 1}, {-half - 0.5, height, 0})));
    add(scene, fixed(box({.5, height, half + 1}, {half + 0.5, height, 0})));
    add(scene, fixed(box({half, height, .5}, {0, height, -half - 0.5})));
    add(scene, fixed(box({half, height, .5}, {0, height, half + 0.5})));
}

/// A thousand boxes and a thousand spheres fall into a bin: every kind of contact at once.
Scene pile() {
    Scene scene;
    addBin(scene);
    Lcg random;
    for (int layer = 0; layer < 20; ++layer)
        for (int i = 0; i < 10; ++i)
            for (int k = 0; k < 10; ++k) {
                const double x = (i - 4.5) * 1.2 + random.number(-.08, .08);
                const double z = (k - 4.5) * 1.2 + random.number(-.08, .08);
                const Vec3 at{x, 1.0 + layer * 1.2, z};
                Body body = (i + k + layer) % 2 == 1 ? sphere(.5, at) : box({.45, .45, .45}, at);
                if (body.kind == Kind::box) {
                    const double angle = random.number(0, 0.6);
                    const double u = random.number(-1, 1), v = random.number(-1, 1);
                    body.pose.rotation = turn({u, v, random.number(.1, 1)}, angle);
                }
                add(scene, body);
            }
    return scene;
}

/// A cloth of n x n spheres, held at one edge: loops of joints.
Scene grid(int n) {
    Scene scene = jointScene();
    scene.watchEnergy = true;
    double mass = 0.0;
    for (int k = 0; k < n; ++k)
        for (int i = 0; i < n; ++i) {
            const double x = k, z = i;
            Body body = ghost(sphere(0.4, {x, 0, z}));
            body.dynamic = i > 0;
            const int id = add(scene, body);  // k n + i
            if (i == 0) continue;
            mass += body.mass();
            addBall(scene, id - 1, id, {x, 0, i - 0.5});
            if (k > 0) addBall(scene, id - n, id, {k - 0.5, 0, z});
        }
    scene.energyScale = mass * kGravity * 0.5 * n;
    return scene;
}

/// One body on one ball joint at the origin: energy over a minute, against the formula.
Scene pendulum(const Body& bob) {
    Scene scene = jointScene();
    scene.watchEnergy = true;
    scene.seconds = 60;
    const int hook = add(scene, ghost(fixed(sphere(.01, {0, 0, 0}))));
    addBall(scene, hook, add(scene, ghost(bob)), {0, 0, 0});
    scene.energyScale = bob.mass() * kGravity * bob.pose.position.x();
    return scene;
}

/// Ten cubes, the top one a hundred times heavier: the mass ratio that contacts suffer from most.
Scene heavyOnTop() {
    Scene scene;
    scene.shouldStand = true;
    addFloor(scene);
    for (int i = 0; i < 10; ++i) add(scene, cube({0, i + 0.5, 0}, i == 9 ? 100000 : 1000));
    return scene;
}

/// A free box spun about its middle axis tumbles for ever (Dzhanibekov): energy and momentum.
Scene freeSpin() {
    Scene scene = jointScene();
    scene.watchEnergy = scene.watchMomentum = true;
    scene.seconds = 60;
    scene.gravity = Vec3::Zero();
    Body body = ghost(box({1.0, 0.5, 0.2}, {0, 0, 0}));
    body.spin = {0.01, 5.0, 0.01};
    add(scene, body);
    scene.energyScale = 0.5 * body.inertia().dot(body.spin.cwiseProduct(body.spin));
    return scene;
}

/// A pendulum that begins 10 degrees from the top.
Scene highPendulum() {
    const double angle = 170 * kPi / 180;
    Scene scene = pendulum(sphere(.05, {std::sin(angle), -std::cos(angle), 0}));
    scene.energyScale = scene.bodies[1].mass() * kGravity * (1.0 - std::cos(angle));
    return scene;
}

/// A ball that keeps its energy at every bounce, for 30 s.
Scene bouncingBall() {
    Scene scene;
    addFloor(scene);
    scene.watchEnergy = true;
    scene.restitution = 1.0;
    scene.seconds = 30;
    const double radius = 0.25, height = 2.0;
    add(scene, sphere(radius, {0, radius + height, 0}));
    scene.energyScale = scene.bodies[1].mass() * kGravity * height;
    return scene;
}

/// A cube on a slope. 30 degrees: tan = .577 < mu, it must stick. 32 degrees: tan = .625 > mu, it
/// must slide with a = g (sin - mu cos).
Scene incline(int degrees) {
    Scene scene;
    const double angle = degrees * kPi / 180;
    const Quat tilt = turn({0, 0, 1}, -angle);
    const Vec3 normal = tilt * Vec3(0, 1, 0);
    scene.slide = std::max(0.0, kGravity * (std::sin(angle) - scene.friction * std::cos(angle)));
    scene.shouldStand = scene.slide == 0.0;
    Body slope = fixed(box({200, 1, 20}, -1.0 * normal));
    Body body = cube(0.5 * normal);
    slope.pose.rotation = body.pose.rotation = tilt;
    add(scene, slope);
    add(scene, body);
    return scene;
}

/// Every body 0.1 mm and 0.2 mrad off: a stack must not depend on perfect symmetry to stand.
Scene perturbed(Scene scene) {
    const double shift = 1e-4, angle = 2e-4;  // m, rad
    Lcg random;
    scene.seconds = 60;
    for (Body& body : scene.bodies) {
        if (!body.dynamic) continue;
        for (double& x : body.pose.position) x += random.number(-shift, shift);
        Vec3 axis;
        for (double& x : axis) x = random.number(-1, 1);
        body.pose.rotation = turn(axis, angle) * body.pose.rotation;
    }
    return scene;
}

Scene lasting(double seconds, Scene scene) {
    scene.seconds = seconds;
    return scene;
}

struct Entry {
    const char* name;
    Scene (*make)();
};

constexpr Entry kScenes[] = {
    {"S1", [] { return stack(20); }},
    {"S1p", [] { return perturbed(stack(20)); }},
    {"S1h", [] { return lasting(120, perturbed(stack(30))); }},
    {"S2", [] { return pyramid(20); }},
    {"S3", [] { return pyramid(60); }},
    {"S3L", [] { return lasting(40, pyramid(60)); }},
    {"S4", wall},
    {"S4p", [] { return perturbed(wall()); }},
    {"S5", [] { return chain(100); }},
    {"S5c", [] { return lasting(120, chain(10)); }},
    {"S6v", [] { return heavyBall(false); }},
    {"S6h", [] { return heavyBall(true); }},
    {"S7", bridge},
    {"S8", pile},
    {"S9", [] { return grid(50); }},
    {"S10", [] { return pendulum(sphere(.05, {1, 0, 0})); }},
    {"S10b", [] { return pendulum(box({.5, .05, .05}, {.5, 0, 0})); }},
    {"S10h", highPendulum},
    {"S11", heavyOnTop},
    {"S11p", [] { return perturbed(heavyOnTop()); }},
    {"S12", freeSpin},
    {"S13a", [] { return incline(30); }},
    {"S13b", [] { return incline(32); }},
    {"S14", bouncingBall},
    {"S15", thrownRods},
    {"C1", ragdolls},
    {"C2", meshCrowd},
    {"C3", hullPile},
    {"C4", turningDrum},
    {"C5", manyPyramids},
    {"C6", [] { return grid(40); }},
    {"C7", [] { return spacedCubes(100, true); }},
    {"C7f", [] { return spacedCubes(100, false); }},
    {"C8", [] { return spacedCubes(224, true); }},
    {"C8f", [] { return spacedCubes(224, false); }},
    {"C9", asleep},
    {"C10", wheelBesidePyramid},
    {"P20", [] { return pyramid(20); }},
    {"P40", [] { return pyramid(40); }},
    {"P60", [] { return pyramid(60); }},
    {"P100", [] { return pyramid(100); }},
};

}  // namespace

/// Touching cubes, `base` at the bottom and one at the top: weight on many paths, and the
/// cost of many contacts. The layout of Box3D's CreateLargePyramid.
Scene pyramid(int base) {
    Scene scene;
    scene.shouldStand = true;
    addFloor(scene);
    const double h = 0.5;
    for (int row = 0; row < base; ++row)
        for (int i = row; i < base; ++i) {
            const double x = (row + 1.0) * h + 2.0 * (i - row) * h - h * base;
            add(scene, cube({x, (2.0 * row + 1) * h, 0}));
        }
    return scene;
}

Scene chain(int links) {
    Scene scene;
    scene.watchPenetration = false;
    scene.watchEnergy = true;
    const double length = 0.5;
    int previous = add(scene, ghost(fixed(sphere(0.05, {0, 0, 0}))));
    double mass = 0.0;
    for (int i = 0; i < links; ++i) {
        const int link = add(scene, ghost(box({.25, .1, .1}, {length * (i + 0.5), 0, 0})));
        mass += scene.bodies[link].mass();
        addBall(scene, previous, link, {length * i, 0, 0});
        previous = link;
    }
    scene.energyScale = mass * kGravity * 0.5 * links * length;
    return scene;
}

int Scene::stepCount() const { return static_cast<int>(std::lround(seconds / step)); }

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const Entry& entry : kScenes) names.push_back(entry.name);
    return names;
}

std::optional<Scene> makeScene(const std::string& name) {
    for (const Entry& entry : kScenes)
        if (name == entry.name) {
            Scene scene = entry.make();
            scene.name = name;
            return scene;
        }
    return {};
}

}  // namespace peers
