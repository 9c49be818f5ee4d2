// With the way o + t d, 0 <= t <= 1, in the shape's own axes:
// plane     t = -n.o / n.d
// sphere    t = m - sqrt((r^2 - |o + m d|^2) / |d|^2),  m = -o.d / |d|^2
// box       the last of the three entries  (-sign(d_i) half_i - o_i) / d_i,  if before every exit
// capsule   as a sphere across its core; beyond the core's ends, the sphere around that end
#include "engine/collision/ray_cast.h"

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

/// By way of the point nearest to the middle: as exact from far away.
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

/// Who enters the endless cylinder beside an end can only enter the capsule there, and so can who
/// begins inside the cylinder.
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

Hit enterLocal(const Shape& shape, const Way& way) {
    switch (shape.type) {
        case ShapeType::sphere: return enterSphere(shape.radius, way);
        case ShapeType::box: return enterBox(shape.halfSize, way);
        case ShapeType::capsule: return enterCapsule(shape.radius, shape.halfLength, way);
        case ShapeType::plane: return enterPlane(shape.normal, way);
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
