// Scenes with many bodies, and with shapes other than boxes and spheres.
#include <cmath>

#include "tests/benchmark/peer_parts.h"

namespace peers {

namespace {

Body capsule(double radius, double halfCore, const Vec3& at) {
    Body body;
    body.kind = Kind::capsule;
    body.radius = radius, body.halfSize = {0, halfCore, 0}, body.pose.position = at;
    return body;
}

/// A hull of 2 n corners about an ellipsoid, each with its opposite.
Body pebble(int n, const Vec3& at, Lcg& random) {
    Body body;
    body.kind = Kind::hull;
    body.pose.position = at;
    for (int i = 0; i < n; ++i) {
        const double up = (i + 0.5) / n;  // evenly over half a sphere
        const double angle = kPi * (3 - std::sqrt(5.0)) * i + random.number(-.1, .1);
        const double side = std::sqrt(1 - up * up);
        const Vec3 corner(.5 * side * std::cos(angle), .4 * up, .5 * side * std::sin(angle));
        body.corners.push_back(corner);
        body.corners.push_back(-corner);
    }
    body.radius = 0.44;
    return body;
}

Body shaken(Body body, Lcg& random) {
    const Vec3 axis(random.number(-1, 1), random.number(-1, 1), random.number(.1, 1));
    body.pose.rotation = turn(axis, random.number(0, 0.6)) * body.pose.rotation;
    return body;
}

void sinkInto(Scene& scene, std::function<double(double, double)> ground) {
    scene.ground = std::move(ground);
    scene.watchPenetration = false;
}

double flat(double, double) { return 0.0; }

/// A ball joint whose b may swing by 1 rad about the axis of its start, and twist by half as much.
void addCone(Scene& scene, int a, int b, const Vec3& at, const Vec3& axis) {
    Joint joint{false, a, b, at, axis};
    joint.most = 1.0, joint.twist = 0.5;
    scene.joints.push_back(joint);
}

void addStoppedHinge(Scene& scene, int a, int b, const Vec3& at) {
    Joint joint{true, a, b, at, {0, 0, 1}};
    joint.most = 1.2;
    scene.joints.push_back(joint);
}

/// Two capsules, upper and lower, on a cone at the top and a stopped hinge between them.
void addLimb(Scene& scene, int body, const Vec3& top, double radius, double length) {
    const double half = length / 2 - radius;
    const Vec3 down(0, -length, 0);
    const int upper = add(scene, capsule(radius, half, top + 0.5 * down));
    const int lower = add(scene, capsule(0.85 * radius, half, top + 1.5 * down));
    addCone(scene, body, upper, top, {0, -1, 0});
    addStoppedHinge(scene, upper, lower, top + down);
}

/// Eleven capsules standing at `foot`, then turned about it.
void addRagdoll(Scene& scene, const Vec3& foot, const Quat& rotation) {
    const std::size_t firstBody = scene.bodies.size(), firstJoint = scene.joints.size();
    const int pelvis = add(scene, capsule(.13, .08, {0, 1.02, 0}));
    scene.bodies.back().pose.rotation = turn({1, 0, 0}, kPi / 2);
    const int chest = add(scene, capsule(.15, .15, {0, 1.42, 0}));
    const int head = add(scene, capsule(.11, .05, {0, 1.86, 0}));
    addCone(scene, pelvis, chest, {0, 1.15, 0}, {0, 1, 0});
    addCone(scene, chest, head, {0, 1.71, 0}, {0, 1, 0});
    for (const double side : {-1.0, 1.0}) {
        addLimb(scene, chest, {0, 1.55, .27 * side}, .055, .36);
        addLimb(scene, pelvis, {0, .9, .11 * side}, .075, .42);
    }
    for (std::size_t i = firstBody; i < scene.bodies.size(); ++i) {
        Pose& pose = scene.bodies[i].pose;
        pose.position = foot + rotation * pose.position;
        pose.rotation = rotation * pose.rotation;
    }
    for (std::size_t i = firstJoint; i < scene.joints.size(); ++i) {
        Joint& joint = scene.joints[i];
        joint.at = foot + rotation * joint.at, joint.axis = rotation * joint.axis;
    }
}

/// m: the height of a wavy ground at the corners of its grid; between them it is two triangles.
double waves(double x, double z) { return 0.4 * std::sin(0.8 * x) * std::cos(0.6 * z); }

constexpr int kCells = 100;      // of the ground, each way
constexpr double kSpacing = 0.4;    // m

double onWaves(double x, double z) {
    const double u = std::floor(x / kSpacing), v = std::floor(z / kSpacing);
    const double s = x / kSpacing - u, t = z / kSpacing - v;
    const auto at = [&](double i, double k) { return waves(kSpacing * (u + i), kSpacing * (v + k)); };
    return s + t < 1 ? at(0, 0) + s * (at(1, 0) - at(0, 0)) + t * (at(0, 1) - at(0, 0))
                     : at(1, 1) + (1 - s) * (at(0, 1) - at(1, 1)) + (1 - t) * (at(1, 0) - at(1, 1));
}

Body wavyGround() {
    Body body;
    body.kind = Kind::mesh;
    const int row = kCells + 1;
    for (int k = 0; k < row; ++k)
        for (int i = 0; i < row; ++i) {
            const double x = kSpacing * (i - kCells / 2), z = kSpacing * (k - kCells / 2);
            body.corners.push_back({x, waves(x, z), z});
        }
    for (int k = 0; k < kCells; ++k)
        for (int i = 0; i < kCells; ++i) {
            const int at = k * row + i;
            body.triangles.push_back({at, at + row, at + 1});
            body.triangles.push_back({at + 1, at + row, at + row + 1});
        }
    return fixed(body);
}

}  // namespace

/// Ten figures of eleven capsules fall on a floor: limits that act on trees of joints.
Scene ragdolls() {
    Scene scene;
    addFloor(scene);
    sinkInto(scene, flat);
    Lcg random;
    for (int i = 0; i < 10; ++i) {
        const Quat tilt = turn({random.number(-1, 1), 0, random.number(.1, 1)}, random.number(0.2, 1.2));
        addRagdoll(scene, {2.5 * (i % 5) - 5, 1.0 + 0.3 * i, 2.5 * (i / 5)}, tilt);
    }
    return scene;
}

/// Boxes, balls, capsules and hulls fall on a wavy mesh of 20,000 triangles.
Scene meshCrowd() {
    Scene scene;
    add(scene, wavyGround());
    scene.lostBelow = -5.0;
    sinkInto(scene, onWaves);
    Lcg random;
    for (int i = 0; i < 42; ++i)
        for (int k = 0; k < 42; ++k) {
            const Vec3 at(0.8 * (i - 20.5), 2.0 + random.number(0, 1), 0.8 * (k - 20.5));
            const int kind = (i + 2 * k) % 4;
            add(scene, shaken(kind == 0   ? box({.25, .25, .25}, at)
                              : kind == 1 ? sphere(.3, at)
                              : kind == 2 ? capsule(.2, .2, at)
                                          : pebble(8, at, random), random));
        }
    return scene;
}

/// Hulls of 32 corners fall in a heap.
Scene hullPile() {
    Scene scene;
    addFloor(scene);
    sinkInto(scene, flat);
    Lcg random;
    for (int layer = 0; layer < 16; ++layer)
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 4; ++k) {
                const Vec3 at(1.1 * (i - 1.5), 1 + 1.1 * layer, 1.1 * (k - 1.5));
                add(scene, shaken(pebble(16, at, random), random));
            }
    return scene;
}

/// A thousand cubes in a turning drum of forty plates.
Scene turningDrum() {
    Scene scene;
    scene.lostBelow = -8.0;
    scene.watchPenetration = false;
    Body drum;
    drum.kind = Kind::drum;
    drum.dynamic = false, drum.spin = {0, 0, 0.5};
    const int plates = 40;
    const double radius = 5, width = 2 * radius * std::tan(kPi / plates);
    for (int i = 0; i < plates; ++i) {
        const double angle = 2 * kPi * i / plates;
        Plate plate{{.25, .55 * width, 3.5}, {}};
        plate.pose.position = Vec3((radius + .25) * std::cos(angle), (radius + .25) * std::sin(angle), 0);
        plate.pose.rotation = turn({0, 0, 1}, angle);
        drum.plates.push_back(plate);
    }
    add(scene, drum);
    for (const double side : {-1.0, 1.0}) add(scene, fixed(box({6, 6, .5}, {0, 0, 3.5 * side})));
    for (int layer = 0; layer < 10; ++layer)
        for (int i = 0; i < 10; ++i)
            for (int k = 0; k < 10; ++k)
                add(scene, box({.2, .2, .2}, {.5 * (i - 4.5), .5 * (layer - 4.5), .5 * (k - 4.5)}));
    return scene;
}

/// Sixteen pyramids of 55 cubes.
Scene manyPyramids() {
    Scene scene;
    scene.shouldStand = true;
    addFloor(scene);
    const Scene one = pyramid(10);
    for (int i = 0; i < 16; ++i)
        for (Body body : one.bodies)
            if (body.dynamic) {
                body.pose.position += Vec3(12.0 * (i % 4) - 18, 0, 4.0 * (i / 4) - 6);
                add(scene, body);
            }
    return scene;
}

/// side x side cubes that do not touch, on the floor or falling on it.
Scene spacedCubes(int side, bool resting) {
    Scene scene;
    addFloor(scene, 2.0 * side);
    scene.seconds = 4;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const double height = resting ? 0.5 : 2 + (7 * i + 13 * k) % 10;
            add(scene, cube({1.5 * (i - .5 * side), height, 1.5 * (k - .5 * side)}));
        }
    return scene;
}

/// Ten thousand that have fallen asleep when the last two seconds begin.
Scene asleep() {
    Scene scene = spacedCubes(100, true);
    scene.sleeps = true;
    return scene;
}

/// A wheel at 100 rad/s beside a pyramid of 300: its trouble is its own.
Scene wheelBesidePyramid() {
    Scene scene = pyramid(24);
    const int axle = add(scene, ghost(fixed(sphere(.05, {0, 3, 5}))));
    Body wheel = ghost(sphere(.5, {0, 3, 5}));
    wheel.spin = {0, 0, 100};
    addHinge(scene, axle, add(scene, wheel), {0, 3, 5});
    return scene;
}

/// Forty-nine rods of aspect 20 thrown with up to 30 rad/s.
Scene thrownRods() {
    Scene scene;
    addFloor(scene);
    Lcg random;
    for (int i = 0; i < 7; ++i)
        for (int k = 0; k < 7; ++k) {
            Body rod = shaken(box({.5, .025, .025}, {1.2 * (i - 3), 2, 1.2 * (k - 3)}), random);
            for (double& x : rod.spin) x = random.number(-17, 17);
            add(scene, rod);
        }
    return scene;
}

}  // namespace peers
