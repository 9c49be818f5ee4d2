// Box:      t = (+-half_i - o_i) / d_i, i the axis of the face
// Cylinder: |(o + t d) across the core|^2 = r^2, the smaller root; sphere: the same in all axes
// Plane:    t = -o_y / d_y
// with the ray o + t d in the surface's own axes.
#include "render/ray_surface.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

Mat3d axesOf(const Quat& rotation) {
    return rotation.cast<double>().normalized().toRotationMatrix();
}

/// World axes turned the shortest way until y is `up`.
Mat3d axesAlong(const Vec3d& up) {
    return Eigen::Quaterniond::FromTwoVectors(Vec3d::UnitY(), up).toRotationMatrix();
}

Surface surfaceOf(const Solid& solid) {
    Surface s{SurfaceKind::box, solid.position.cast<double>(), axesOf(solid.rotation),
              solid.halfSize.cast<double>(), solid.id};
    if (solid.shape == SolidShape::box) return s;
    s.kind = SurfaceKind::capsule;
    if (solid.shape == SolidShape::sphere) s.half.y() = 0.0;
    return s;
}

Surface surfaceOf(const Rod& rod) {
    const Vec3d from = rod.from.cast<double>(), to = rod.to.cast<double>();
    const Vec3d along = to - from;
    const bool hasLength = along.norm() > 0.0;
    const double radius = static_cast<double>(rod.radius);
    return {SurfaceKind::bar, 0.5 * (from + to), hasLength ? axesAlong(along) : Mat3d::Identity(),
            Vec3d(radius, 0.5 * along.norm(), radius), rod.id};
}

Surface surfaceOf(const Ground& ground) {
    const Vec3d n = ground.normal.cast<double>().normalized();
    return {SurfaceKind::plane, static_cast<double>(ground.offset) * n, axesAlong(n),
            Vec3d::Zero(), ground.id};
}

/// The smaller root of a t^2 + 2 b t + c = 0; where there is none, the lowest point of the curve.
double firstRoot(double a, double b, double c) {
    return (-b - std::sqrt(std::max(b * b - a * c, 0.0))) / a;
}

/// A face seen edge-on has no sharp answer; none is outside the sphere around the box.
Hit enterBox(const Vec3d& half, int face, const Vec3d& o, const Vec3d& d) {
    const int axis = std::min(face / 2, 2);
    const double side = face % 2 == 1 ? 1.0 : -1.0;
    const double t = (side * half[axis] - o[axis]) / d[axis];
    const double middle = -o.dot(d) / d.squaredNorm(), reach = half.norm() / d.norm();
    return {std::max(middle - reach, std::min(t, middle + reach)), side * Vec3d::Unit(axis)};
}

Hit enterBall(double radius, const Vec3d& centre, const Vec3d& o, const Vec3d& d) {
    const Vec3d w = o - centre;
    const double t = firstRoot(d.squaredNorm(), w.dot(d), w.squaredNorm() - radius * radius);
    return {t, (w + t * d).normalized()};
}

Hit enterCylinder(double radius, const Vec3d& o, const Vec3d& d) {
    const Vec3d w(o.x(), 0, o.z()), e(d.x(), 0, d.z());
    const double t = firstRoot(e.squaredNorm(), w.dot(e), w.squaredNorm() - radius * radius);
    return {t, (w + t * e).normalized()};
}

/// A ray that comes into the endless cylinder beyond an end can only come into the capsule there.
Hit enterCapsule(const Vec3d& half, const Vec3d& o, const Vec3d& d) {
    const Vec3d end(0, half.y(), 0);
    if (half.y() == 0.0) return enterBall(half.x(), Vec3d::Zero(), o, d);
    if (d.x() == 0.0 && d.z() == 0.0) return enterBall(half.x(), d.y() > 0 ? -end : end, o, d);
    const Hit side = enterCylinder(half.x(), o, d);
    const double y = o.y() + side.t * d.y();
    if (std::abs(y) <= half.y()) return side;
    return enterBall(half.x(), y > 0.0 ? end : -end, o, d);
}

/// At the horizon itself the ray may just miss it.
Hit enterPlane(const Vec3d& o, const Vec3d& d) {
    constexpr double kHorizon = 1e7;  // times the ray's `along`
    const double t = -o.y() / d.y();
    return {t > 0.0 && t < kHorizon ? t : kHorizon, Vec3d(0, o.y() > 0.0 ? 1 : -1, 0)};
}

Hit enterLocal(const Surface& s, int face, const Vec3d& o, const Vec3d& d) {
    switch (s.kind) {
        case SurfaceKind::box: return enterBox(s.half, face, o, d);
        case SurfaceKind::capsule: return enterCapsule(s.half, o, d);
        case SurfaceKind::bar: return enterCylinder(s.half.x(), o, d);
        case SurfaceKind::plane: return enterPlane(o, d);
    }
    return {};
}

}  // namespace

std::vector<Surface> surfacesOf(const Frame& frame) {
    std::vector<Surface> surfaces;
    for (const Solid& solid : frame.solids) surfaces.push_back(surfaceOf(solid));
    for (const Rod& rod : frame.rods) surfaces.push_back(surfaceOf(rod));
    for (const Ground& ground : frame.grounds) surfaces.push_back(surfaceOf(ground));
    return surfaces;
}

Hit enter(const Surface& surface, int face, const Ray& ray) {
    const Vec3d o = surface.axes.transpose() * (ray.from - surface.at);
    const Vec3d d = surface.axes.transpose() * ray.along;
    Hit hit = enterLocal(surface, face, o, d);
    hit.normal = surface.axes * hit.normal;
    return hit;
}

}  // namespace render
