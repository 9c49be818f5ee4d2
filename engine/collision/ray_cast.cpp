// With the ray o + t d, 0 <= t <= 1, in the shape's own axes:
// plane     t = -n.o / n.d
// sphere    t = m - sqrt((r^2 - |o + m d|^2) / |d|^2),  m = -o.d / |d|^2
// box       the last of the three entries  (-sign(d_i) half_i - o_i) / d_i,  if before every exit
// cylinder  a sphere across its axis, between its ends, or an end inside the rim
// cone      x^2 + z^2 = (r (top - y) / h)^2, or its base inside the rim
// hull      the last entry into a half space, if before every exit
// mesh      the first triangle hit from its front
// capsule   a sphere across its core; beyond the core's ends, the sphere around that end
#include "engine/collision/ray_cast.h"

#include "engine/collision/pieces.h"
#include "engine/shapes/hull.h"
#include "engine/shapes/inside.h"

namespace engine {
namespace {

struct Way {
    Vec3 o, d;
};

using Hit = std::optional<SurfaceHit>;

Way turnedInto(const Pose& pose, const Vec3& from, const Vec3& to) {
    const Mat3 turn = pose.rotation.toRotationMatrix().transpose();
    return {turn * (from - pose.position), turn * (to - from)};
}

bool isOnWay(double t) { return t >= 0.0 && t <= 1.0; }

Hit enterPlane(const Vec3& n, const Way& way) {
    const double height = n.dot(way.o), down = -n.dot(way.d);
    if (height < 0.0 || down <= 0.0 || height > down) return std::nullopt;
    return SurfaceHit{height / down, n};
}

/// Via the ray's point nearest to the centre, so that it is as exact from far away.
Hit enterSphere(double radius, const Way& way) {
    const double wayWay = way.d.squaredNorm(), nearest = -way.o.dot(way.d) / wayWay;
    if (way.o.squaredNorm() <= radius * radius || !(nearest > 0.0)) return std::nullopt;
    const double square = radius * radius - (way.o + nearest * way.d).squaredNorm();
    if (square < 0.0) return std::nullopt;
    const double t = nearest - std::sqrt(square / wayWay);
    if (!isOnWay(t)) return std::nullopt;
    return SurfaceHit{t, (way.o + t * way.d).normalized()};
}

Hit enterBox(const Vec3& half, const Way& way) {
    double in = -1.0, out = 1.0;
    int axis = -1;
    for (int i = 0; i < 3; ++i) {
        const double d = way.d[i], o = way.o[i];
        if (d == 0.0) {
            if (std::abs(o) > half[i]) return std::nullopt;
            continue;
        }
        const double side = d > 0.0 ? half[i] : -half[i];
        const double first = (-side - o) / d;
        if (first > in) in = first, axis = i;
        out = smaller(out, (side - o) / d);
    }
    if (axis < 0 || in < 0.0 || in > out) return std::nullopt;
    return SurfaceHit{in, way.d[axis] > 0.0 ? Vec3(-Vec3::Unit(axis)) : Vec3(Vec3::Unit(axis))};
}

/// A ray that enters the infinite cylinder beyond an end can only enter the capsule at that end; so
/// can a ray that begins inside the cylinder.
Hit enterCapsule(double radius, double halfLength, const Way& way) {
    const Way across{Vec3(way.o.x(), 0.0, way.o.z()), Vec3(way.d.x(), 0.0, way.d.z())};
    const Hit side = enterSphere(radius, across);
    const bool inside = across.o.squaredNorm() <= radius * radius;
    if (!side && !inside) return std::nullopt;
    const double y = way.o.y() + (side ? side->fraction * way.d.y() : 0.0);
    if (std::abs(y) <= halfLength) return inside ? std::nullopt : side;
    const Vec3 end(0.0, y > 0.0 ? halfLength : -halfLength, 0.0);
    return enterSphere(radius, {way.o - end, way.d});
}

/// Where the ray enters a flat end at height y from outside, within the rim.
Hit enterEnd(double y, double radius, const Way& way) {
    const double side = y < 0.0 ? -1.0 : 1.0;
    if (side * way.d.y() >= 0.0 || side * (way.o.y() - y) < 0.0) return std::nullopt;
    const double t = (y - way.o.y()) / way.d.y();
    const Vec3 p = way.o + t * way.d;
    if (!isOnWay(t) || p.x() * p.x() + p.z() * p.z() > radius * radius) return std::nullopt;
    return SurfaceHit{t, Vec3(0.0, side, 0.0)};
}

Hit sooner(const Hit& a, const Hit& b) {
    if (!a || !b) return a ? a : b;
    return b->fraction < a->fraction ? b : a;
}

Hit enterCylinder(double radius, double half, const Way& way) {
    const Way across{Vec3(way.o.x(), 0.0, way.o.z()), Vec3(way.d.x(), 0.0, way.d.z())};
    Hit side = enterSphere(radius, across);
    if (side && std::abs(way.o.y() + side->fraction * way.d.y()) > half) side.reset();
    return sooner(side, sooner(enterEnd(-half, radius, way), enterEnd(half, radius, way)));
}

/// The side: |across|^2 = (slope (top - y))^2, the first root that enters below the tip.
Hit enterCone(double radius, double half, const Way& way) {
    const double base = -0.5 * half, top = 1.5 * half, slope = radius / (2.0 * half);
    const double o = slope * (top - way.o.y()), d = -slope * way.d.y();
    const double a = way.d.x() * way.d.x() + way.d.z() * way.d.z() - d * d;
    const double b = way.o.x() * way.d.x() + way.o.z() * way.d.z() - o * d;
    const double c = way.o.x() * way.o.x() + way.o.z() * way.o.z() - o * o;
    Hit side;
    const double square = b * b - a * c;
    if (square >= 0.0) {
        const double q = -(b + (b < 0.0 ? -1.0 : 1.0) * std::sqrt(square));  // avoids cancellation
        for (const double t : {a != 0.0 ? q / a : -1.0, q != 0.0 ? c / q : -1.0}) {
            const Vec3 p = way.o + t * way.d;
            if (!isOnWay(t) || p.y() < base || p.y() > top) continue;
            const double across = std::sqrt(p.x() * p.x() + p.z() * p.z());
            if (across == 0.0) continue;
            const Vec3 n = Vec3(p.x() / across, slope, p.z() / across).normalized();
            if (n.dot(way.d) < 0.0) side = sooner(side, SurfaceHit{t, n});
        }
    }
    return sooner(side, enterEnd(base, radius, way));
}

Hit enterHull(const Hull& hull, const Way& way) {
    double in = -1.0, out = 1.0;
    Vec3 normal = Vec3::UnitY();
    for (const Hull::Face& face : hull.faces) {
        const double height = face.normal.dot(way.o) - face.offset, d = face.normal.dot(way.d);
        if (d == 0.0 && height > 0.0) return std::nullopt;
        if (d < 0.0 && -height / d > in) in = -height / d, normal = face.normal;
        if (d > 0.0) out = smaller(out, -height / d);
    }
    if (in < 0.0 || in > out) return std::nullopt;
    return SurfaceHit{in, normal};
}

Hit enterTriangle(const Mesh& mesh, const Mesh::Triangle& triangle, const Way& way) {
    const Vec3& n = triangle.normal;
    const Vec3& a = mesh.corners[triangle.corners[0]];
    const double down = -n.dot(way.d), height = n.dot(way.o - a);
    if (down <= 0.0 || height < 0.0 || height > down) return std::nullopt;
    const Vec3 p = way.o + (height / down) * way.d;
    for (int i = 0; i < 3; ++i) {
        const Vec3& from = mesh.corners[triangle.corners[i]];
        const Vec3& to = mesh.corners[triangle.corners[(i + 1) % 3]];
        // A point on the seam of two triangles must be in one of them.
        if (n.dot((to - from).cross(p - from)) < -1e-12 * (to - from).squaredNorm())
            return std::nullopt;
    }
    return SurfaceHit{height / down, n};
}

Hit enterMesh(const Mesh& mesh, const Way& way) {
    const Vec3 end = way.o + way.d;
    Hit first;
    mesh.query({way.o.cwiseMin(end), way.o.cwiseMax(end)}, [&](int i) {
        first = sooner(first, enterTriangle(mesh, mesh.triangles[i], way));
    });
    return first;
}

/// A ray that begins inside one of the parts begins inside the compound.
Hit enterCompound(const ShapeParts& parts, const Way& way) {
    Hit first;
    for (const ShapePart& part : parts)
        if (isInside(part.shape, part.pose.toLocal(way.o))) return std::nullopt;
    for (const ShapePart& part : parts)
        first = sooner(first, enterShape(part.shape, part.pose, way.o, way.o + way.d));
    return first;
}

Hit enterLocal(const Shape& shape, const Way& way) {
    switch (shape.type) {
        case ShapeType::sphere: return enterSphere(shape.radius, way);
        case ShapeType::box: return enterBox(shape.halfSize, way);
        case ShapeType::capsule: return enterCapsule(shape.radius, shape.halfLength, way);
        case ShapeType::plane: return enterPlane(shape.normal, way);
        case ShapeType::cylinder: return enterCylinder(shape.radius, shape.halfLength, way);
        case ShapeType::cone: return enterCone(shape.radius, shape.halfLength, way);
        case ShapeType::hull: return enterHull(*shape.hull, way);
        case ShapeType::compound: return enterCompound(*shape.parts, way);
        case ShapeType::mesh: return enterMesh(*shape.mesh, way);
    }
    return std::nullopt;
}

}  // namespace

std::optional<SurfaceHit> enterShape(const Shape& shape, const Pose& pose, const Vec3& from,
                                     const Vec3& to) {
    Hit hit = enterLocal(shape, turnedInto(pose, from, to));
    if (hit) hit->normal = pose.rotation * hit->normal;
    return hit;
}

}  // namespace engine
