#include "tests/behaviour/torture/worlds.h"

#include <array>
#include <cmath>
#include <numbers>

namespace torture {
namespace {

using namespace engine;
using support::Random;

int count(Random& r, int low, int high) {
    return low + static_cast<int>(r.number(0, high - low + 1 - 1e-9));
}

Shape hull(Random& r, double size, double aspect) {
    for (;;) {
        std::vector<Vec3> points;
        const int corners = count(r, 5, 20);
        for (int i = 0; i < corners; ++i) {
            const Vec3 p = r.vector(1).normalized() * size;
            points.push_back({p.x(), p.y() / aspect, p.z() / std::sqrt(aspect)});
        }
        if (const auto shape = Shape::hullOf(points)) return *shape;
    }
}

/// A random shape for dynamic bodies, its longest side about `size` (m).
Shape anyShape(Random& r, double size, double mostAspect) {
    const double aspect = logarithmic(r, 1, mostAspect);
    switch (count(r, 0, 6)) {
        case 0: return Shape::sphere(size / 2);
        case 1: return Shape::capsule(size / 2 / larger(aspect, 1.01), size);
        case 2: return Shape::cylinder(size / 2 / aspect, size);
        case 3: return Shape::cylinder(size / 2, size / aspect);
        case 4: return hull(r, size / 2, smaller(aspect, 20.0));
        case 5: {
            const ShapePart parts[2] = {
                {Shape::box({size, size / aspect, size / aspect}), {}, 1.0},
                {Shape::sphere(size / 4), {{size / 2, 0, 0}, Quat::Identity()}, 2.0}};
            return Shape::compound(parts);
        }
        default:
            return Shape::box({size, size / aspect, chance(r, 0.5) ? size : size / aspect});
    }
}

BodyDef anyBody(Random& r, const Vec3& at, double size, double mostAspect = 100.0) {
    BodyDef def = support::body(anyShape(r, size, mostAspect), at, logarithmic(r, 1e-3, 1e3));
    def.pose.rotation = r.rotation();
    def.material.friction = r.number(0, 1.2);
    if (chance(r, 0.2)) def.material.restitution = r.number(0, 0.9);
    if (chance(r, 0.2)) def.material.rolling = r.number(0, 0.02);
    return def;
}

Vec3 anyPlace(Random& r, const Case& c, double low, double high) {
    const double reach = 0.7 * c.half;
    const double x = r.number(-reach, reach), y = r.number(low, high);
    return {x, y, r.number(-reach, reach)};
}

void addBody(Case& c, const BodyDef& def) { c.bodies.push_back(c.world.add(def)); }

/// Planes on all sides; `floor`: also below.
void addBox(Case& c, double half, bool floor) {
    c.half = half;
    if (floor) c.world.add(support::floorPlane());
    for (const Vec3& out : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
        c.world.add(support::fixed(Shape::plane(-out), half * out));
}

void rain(Case& c, Random& r) {
    addBox(c, 6, true);
    const int n = count(r, 20, 60);
    for (int i = 0; i < n; ++i) {
        BodyDef def = anyBody(r, anyPlace(r, c, 1, 15), r.number(0.2, 1.5));
        def.velocity = r.vector(15), def.spin = r.vector(20);
        addBody(c, def);
    }
}

void shots(Case& c, Random& r) {
    addBox(c, 8, true);
    const int walls = count(r, 2, 6);
    for (int i = 0; i < walls; ++i) {
        BodyDef wall = support::fixed(Shape::box({4, 3, 0.05}), anyPlace(r, c, 1, 3));
        wall.pose.rotation = r.rotation();
        c.world.add(wall);
    }
    const int n = count(r, 5, 25);
    for (int i = 0; i < n; ++i) {
        BodyDef def = anyBody(r, anyPlace(r, c, 1, 6), r.number(0.1, 0.8));
        def.velocity = r.vector(1).normalized() * logarithmic(r, 10, 300);
        def.spin = r.vector(1).normalized() * logarithmic(r, 1, 200);
        addBody(c, def);
    }
}

void terrain(Case& c, Random& r) {
    addBox(c, 8, false);
    c.columns = 24;
    c.spacing = 16.0 / (c.columns - 1);
    const double rough = logarithmic(r, 0.05, 0.8);
    for (int i = 0; i < c.columns * c.columns; ++i) c.heights.push_back(r.number(0, rough));
    c.world.add(support::fixed(Shape::heightField(c.columns, c.columns, c.spacing, c.heights)));
    const int n = count(r, 20, 50);
    for (int i = 0; i < n; ++i) {
        BodyDef def = anyBody(r, anyPlace(r, c, 2, 12), r.number(0.05, 1.0), 20.0);
        def.velocity = Vec3(0, -logarithmic(r, 0.1, 200), 0) + r.vector(5);
        def.spin = r.vector(10);
        addBody(c, def);
    }
}

void triangles(Case& c, Random& r) {
    addBox(c, 8, false);
    std::vector<Vec3> corners;
    std::vector<std::array<int, 3>> faces;
    // A grid with random lines, so slivers and needles between them. It extends beyond the walls.
    const int lines = count(r, 6, 16);
    std::vector<double> x{-9.0}, z{-9.0};
    for (int i = 0; i < lines; ++i) {
        x.push_back(x.back() + logarithmic(r, 0.01, 1) * 18.0 / lines);
        z.push_back(z.back() + logarithmic(r, 0.01, 1) * 18.0 / lines);
    }
    x.push_back(9.0), z.push_back(9.0);
    const int n = static_cast<int>(x.size());
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) corners.push_back({x[i], 0.0, z[j]});
    for (int j = 0; j + 1 < n; ++j)
        for (int i = 0; i + 1 < n; ++i) {
            const int a = j * n + i, b = a + 1, d = a + n, e = d + 1;
            if (chance(r, 0.5)) faces.push_back({a, d, b}), faces.push_back({b, d, e});
            else faces.push_back({a, d, e}), faces.push_back({a, e, b});
        }
    c.world.add(support::fixed(Shape::meshOf(corners, faces)));
    const int many = count(r, 20, 50);
    for (int i = 0; i < many; ++i) {
        BodyDef def = anyBody(r, anyPlace(r, c, 2, 12), r.number(0.05, 1.0), 20.0);
        if (chance(r, 0.3)) {  // at a corner
            const Vec3 at = corners[count(r, 0, n * n - 1)];
            if (at.cwiseAbs().maxCoeff() < 7.0) def.pose.position = at + Vec3(0, r.number(2, 8), 0);
        }
        def.velocity = Vec3(0, -logarithmic(r, 0.1, 300), 0);
        if (chance(r, 0.5)) def.velocity += r.vector(5), def.spin = r.vector(10);
        addBody(c, def);
    }
}

/// Free coordinates of a joint get limits, a motor or a spring, or nothing.
void drive(Random& r, JointDef& def, bool motors) {
    const auto freedom = [&](double reach) {
        Freedom f;
        if (chance(r, 0.4)) f.limits = {-r.number(0, reach), r.number(0, reach)};
        if (motors && chance(r, 0.3)) f.motor = {r.number(-10, 10), logarithmic(r, 0.1, 1e3)};
        else if (chance(r, 0.3)) f.motor = {0.0, logarithmic(r, 1e-3, 10)};  // a brake
        if (chance(r, 0.2)) f.spring.hz = logarithmic(r, 0.5, 30), f.spring.damping = r.number(0, 1);
        return f;
    };
    switch (def.type) {
        case JointType::ball:
            if (chance(r, 0.3)) def.free[1].limits = {0.0, r.number(0.2, 2.0)};
            break;
        case JointType::hinge: def.free[0] = freedom(2.0); break;
        case JointType::slider: def.free[0] = freedom(0.4), def.free[0].limits = {-0.4, 0.4}; break;
        case JointType::universal: def.free[0] = freedom(1.0), def.free[1] = freedom(1.0); break;
        case JointType::sixDof:
            for (int i = 0; i < 6; ++i) {
                def.free[i].locked = i < 3 || chance(r, 0.5);
                if (i >= 3 && !def.free[i].locked) def.free[i] = freedom(1.0);
            }
            break;
        default: break;
    }
}

JointType anyType(Random& r) {
    constexpr JointType kTypes[] = {JointType::ball,      JointType::hinge, JointType::weld,
                                    JointType::slider,    JointType::universal,
                                    JointType::distance,  JointType::sixDof,
                                    JointType::constantVelocity};
    return kTypes[count(r, 0, 7)];
}

void join(Case& c, Random& r, BodyId a, BodyId b, const Vec3& at, JointType type, bool motors,
          double apart = 0.0) {
    JointDef def;
    def.type = type;
    def.a = a, def.b = b;
    def.axis = r.vector(1).normalized();
    def.axis2 = def.axis;
    if (type == JointType::universal || type == JointType::sixDof)
        def.axis2 = def.axis.cross(Vec3(def.axis.z(), def.axis.x(), def.axis.y() + 2.0)).normalized();
    def.anchorA = c.world.pose(a).toLocal(at);
    def.anchorB = c.world.pose(b).toLocal(Vec3(at + r.vector(apart)));
    if (type == JointType::distance) {
        def.anchorA = def.anchorB = Vec3::Zero();
        def.length = (c.world.pose(b).position - c.world.pose(a).position).norm();
    }
    drive(r, def, motors);
    addJoint(c, def);
}

/// Bodies, each joined to an earlier one; the first sometimes to the world.
void limbs(Case& c, Random& r, double apart = 0.0) {
    addBox(c, 10, true);
    const bool motors = chance(r, 0.5);
    const int creatures = count(r, 1, 4);
    for (int k = 0; k < creatures; ++k) {
        const Vec3 start = anyPlace(r, c, 4, 8);
        const double weight = logarithmic(r, 1e-2, 1e2);
        std::vector<BodyId> parts;
        if (chance(r, 0.3)) parts.push_back(c.world.add(support::hook(start)));
        const int n = count(r, 2, 14);
        for (int i = 0; i < n; ++i) {
            const double size = r.number(0.2, 0.8);
            BodyDef def = anyBody(r, start, size, 10.0);
            def.mass = weight * logarithmic(r, 0.1, 10);
            if (parts.empty()) {
                addBody(c, def);
                parts.push_back(c.bodies.back());
                continue;
            }
            const BodyId to = parts[count(r, 0, static_cast<int>(parts.size()) - 1)];
            const Vec3 way = r.vector(1).normalized();
            const Vec3 from = c.world.pose(to).position;
            def.pose.position = from + way * size;
            def.velocity = r.vector(5);
            addBody(c, def);
            join(c, r, to, c.bodies.back(), Vec3(from + way * (size / 2)), anyType(r), motors, apart);
            parts.push_back(c.bodies.back());
        }
    }
    const int loose = count(r, 0, 10);
    for (int i = 0; i < loose; ++i) addBody(c, anyBody(r, anyPlace(r, c, 1, 4), r.number(0.2, 1.0)));
}

void loops(Case& c, Random& r) {
    addBox(c, 8, true);
    const int rings = count(r, 1, 3);
    for (int k = 0; k < rings; ++k) {
        const int n = count(r, 3, 12);
        const double radius = r.number(0.5, 1.5), misfit = chance(r, 0.5) ? 0.0 : logarithmic(r, 1e-5, 0.03);
        const Vec3 middle = anyPlace(r, c, 3, 8);
        const JointType type = chance(r, 0.4) ? JointType::ball : chance(r, 0.5) ? JointType::hinge
                                                                                : JointType::weld;
        const Vec3 along = chance(r, 0.7) ? Vec3(Vec3::UnitZ()) : r.vector(1).normalized();
        const double mass = logarithmic(r, 0.01, 100);
        std::vector<BodyId> ring;
        const auto at = [&](double i) {
            const double u = 2 * std::numbers::pi * i / n;
            return Vec3(middle + radius * Vec3(std::cos(u), std::sin(u), 0));
        };
        for (int i = 0; i < n; ++i) {
            const Vec3 way = at(i + 1) - at(i);
            BodyDef def = support::body(Shape::box({way.norm(), 0.1, 0.1}), 0.5 * (at(i) + at(i + 1)),
                                        mass * r.number(0.5, 2));
            def.pose.rotation = support::turnInPlane(way);
            def.velocity = r.vector(2);
            addBody(c, def);
            ring.push_back(c.bodies.back());
        }
        for (int i = 0; i < n; ++i) {
            JointDef def;
            def.type = type, def.axis = along;
            def.a = ring[i], def.b = ring[(i + 1) % n];
            const Vec3 where = at(i + 1) + r.vector(misfit);
            def.anchorA = c.world.pose(def.a).toLocal(where);
            def.anchorB = c.world.pose(def.b).toLocal(Vec3(where + r.vector(misfit)));
            c.world.add(def);
        }
        if (chance(r, 0.4)) join(c, r, c.world.add(support::hook(at(0))), ring[0], at(0), JointType::ball, false);
    }
    const int loose = count(r, 5, 20);
    for (int i = 0; i < loose; ++i) addBody(c, anyBody(r, anyPlace(r, c, 0.5, 2), r.number(0.2, 1.0)));
}

void weights(Case& c, Random& r) {
    addBox(c, 5, true);
    const int towers = count(r, 1, 4);
    for (int k = 0; k < towers; ++k) {
        double y = 0.0;
        const double x = -3.0 + 2.0 * k, slant = r.number(0, 0.01);
        const int n = count(r, 2, 12);
        for (int i = 0; i < n; ++i) {
            const double size = r.number(0.2, 1.2);
            BodyDef def = support::body(Shape::box({size, size / 2, size}), {x, y + size / 4, 0},
                                        i % 2 == 1 ? logarithmic(r, 10, 1e3) : logarithmic(r, 1e-3, 0.1));
            def.pose.rotation = Quat(1, 0, slant, 0).normalized();
            y += size / 2;
            addBody(c, def);
        }
    }
}

void overlaps(Case& c, Random& r) {
    addBox(c, 6, true);
    const int n = count(r, 10, 60);
    const double reach = r.number(0.0, 1.5);
    for (int i = 0; i < n; ++i)
        addBody(c, anyBody(r, Vec3(0, 1.0, 0) + r.vector(reach), r.number(0.2, 1.2), 30.0));
}

void bounces(Case& c, Random& r) {
    addBox(c, 5, true);
    const int n = count(r, 3, 20);
    for (int i = 0; i < n; ++i) {
        BodyDef def = anyBody(r, anyPlace(r, c, 1, 6), r.number(0.2, 0.8), 5.0);
        def.material.restitution = chance(r, 0.5) ? 1.0 : r.number(0, 1);
        def.material.friction = chance(r, 0.5) ? 0.0 : r.number(0, 2);
        def.velocity = r.vector(10), def.spin = r.vector(10);
        addBody(c, def);
    }
}

void movers(Case& c, Random& r) {
    rain(c, r);
    const int n = count(r, 1, 4);
    for (int i = 0; i < n; ++i) {
        BodyDef def = support::body(Shape::box({r.number(1, 4), 0.3, r.number(0.3, 2)}),
                                    anyPlace(r, c, 0.5, 2));
        def.kind = BodyKind::kinematic;
        def.mass.reset();
        if (chance(r, 0.7)) def.spin = {0, r.number(-8, 8), chance(r, 0.3) ? 3.0 : 0.0};
        c.world.add(def);
    }
    c.ceiling = 0.0;
}

/// Height of the field between its corners, m: not below the lowest of the four.
double ground(const Case& c, const Vec3& at) {
    if (c.heights.empty()) return 0.0;
    const auto cell = [&](double x) {
        return static_cast<int>(clamped((x + c.half) / c.spacing, 0.0, c.columns - 1.001));
    };
    const int i = cell(at.x()), j = cell(at.z());
    const auto h = [&](int k, int l) { return c.heights[l * c.columns + k]; };
    return smaller(smaller(h(i, j), h(i + 1, j)), smaller(h(i, j + 1), h(i + 1, j + 1)));
}

}  // namespace

const char* nameOf(Kind kind) {
    constexpr const char* kNames[] = {"rain",    "shots",    "terrain", "triangles", "limbs", "loops",
                                      "weights", "overlaps", "torn",    "bounces",   "movers", "machines"};
    return kNames[static_cast<int>(kind)];
}

double Case::outside(BodyId id) const {
    const Vec3& at = world.pose(id).position;
    const double side = larger(std::abs(at.x()), std::abs(at.z())) - half;
    return larger(side, ground(*this, at) - at.y());
}

void addJoint(Case& c, const JointDef& def) {
    c.world.add(def);
    for (const Freedom& f : def.free)
        if (f.motor.isOn()) c.power += std::abs(f.motor.speed) * f.motor.strength;
}

Case makeCase(Kind kind, int number, const Settings& settings) {
    Case c;
    c.world = World(settings);
    c.kind = kind;
    c.name = nameOf(kind) + std::to_string(number);
    constexpr int kSeeds = 11;  // a new kind must not change the other worlds
    Random r(static_cast<std::uint64_t>(kSeeds * number + static_cast<int>(kind)) + 1);
    c.ceiling = 1.0;
    switch (c.kind) {
        case Kind::rain: rain(c, r); break;
        case Kind::shots: shots(c, r); break;
        case Kind::terrain: terrain(c, r); break;
        case Kind::triangles: triangles(c, r); break;
        case Kind::limbs: limbs(c, r); break;
        case Kind::loops: loops(c, r); break;
        case Kind::weights: weights(c, r); break;
        case Kind::overlaps: overlaps(c, r); break;
        case Kind::torn: limbs(c, r, r.number(0.01, 0.3)); break;
        case Kind::bounces: bounces(c, r); break;
        case Kind::movers: movers(c, r); break;
        case Kind::machines:
            addBox(c, 10, true);
            addMachines(c, r);
            break;
        case Kind::count: break;
    }
    if (c.ceiling > 0.0) c.ceiling = c.world.energy().total();
    return c;
}

}  // namespace torture
