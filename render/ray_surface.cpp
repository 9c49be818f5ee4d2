// Box:      t = (+-half_i - o_i) / d_i, i the axis of the face
// Cylinder: |(o + t d) across the core|^2 = r^2, the smaller root; sphere: the same in all axes
// Plane:    t = -o_y / d_y
// Cone:     x^2 + z^2 = k^2 y^2 from the tip down, k = radius / height
// Mesh:     n . (o + t d) = n . a, n the normal of the triangle's or facet's plane, a on it
// with the ray o + t d in the surface's axes.
#include "render/ray_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/mesh_tree.h"
#include "render/shortest_turn.h"
#include "render/surface_map.h"

namespace render {
namespace {

Mat3d axesOf(const Quat& rotation) {
    return rotation.cast<double>().normalized().toRotationMatrix();
}

/// The world axes, rotated the shortest way so that y is `up`.
Mat3d axesAlong(const Vec3d& up) { return shortestTurn<double>(Vec3d::UnitY(), up).toRotationMatrix(); }

SurfaceKind kindOf(const Solid& solid) {
    switch (solid.shape) {
        case SolidShape::box: return SurfaceKind::box;
        case SolidShape::sphere:
        case SolidShape::capsule: return SurfaceKind::capsule;
        case SolidShape::cylinder: return SurfaceKind::cylinder;
        case SolidShape::cone: return SurfaceKind::cone;
        case SolidShape::mesh: break;
    }
    if (!solid.mesh) return SurfaceKind::box;
    return solid.mesh->planes.empty() ? SurfaceKind::mesh : SurfaceKind::hull;
}

Surface surfaceOf(const Rod& rod) {
    const Vec3d from = rod.from.cast<double>(), to = rod.to.cast<double>();
    const Vec3d along = to - from;
    const bool hasLength = along.norm() > 0.0;
    const double radius = static_cast<double>(rod.radius);
    return {SurfaceKind::bar, 0.5 * (from + to), hasLength ? axesAlong(along) : Mat3d::Identity(),
            Vec3d(radius, 0.5 * along.norm(), radius), rod.id, nullptr};
}

Surface surfaceOf(const Ground& ground) {
    const Vec3d n = ground.normal.cast<double>().normalized();
    return {SurfaceKind::plane, static_cast<double>(ground.offset) * n, axesAlong(n),
            Vec3d::Zero(), ground.id, nullptr};
}

/// The smaller root of a t^2 + 2 b t + c = 0; if there is none, the curve's minimum.
double firstRoot(double a, double b, double c) {
    return (-b - std::sqrt(std::max(b * b - a * c, 0.0))) / a;
}

/// Limits t to the sphere around a body: for a face seen edge-on, t is ill-conditioned.
double within(double radius, double t, const Vec3d& o, const Vec3d& d) {
    const double middle = -o.dot(d) / d.squaredNorm(), reach = radius / d.norm();
    return std::max(middle - reach, std::min(t, middle + reach));
}

Hit enterBox(const Vec3d& half, int face, const Vec3d& o, const Vec3d& d) {
    const int axis = std::min(face / 2, 2);
    const double side = face % 2 == 1 ? 1.0 : -1.0;
    const double t = (side * half[axis] - o[axis]) / d[axis];
    return {within(half.norm(), t, o, d), side * Vec3d::Unit(axis)};
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

/// A ray that enters the infinite cylinder beyond an end can enter the capsule only at that end.
Hit enterCapsule(const Vec3d& half, const Vec3d& o, const Vec3d& d) {
    const Vec3d end(0, half.y(), 0);
    if (half.y() == 0.0) return enterBall(half.x(), Vec3d::Zero(), o, d);
    if (d.x() == 0.0 && d.z() == 0.0) return enterBall(half.x(), d.y() > 0 ? -end : end, o, d);
    const Hit side = enterCylinder(half.x(), o, d);
    const double y = o.y() + side.t * d.y();
    if (std::abs(y) <= half.y()) return side;
    return enterBall(half.x(), y > 0.0 ? end : -end, o, d);
}

/// The ends are treated like faces of a box.
Hit enterClosed(const Vec3d& half, int face, const Vec3d& o, const Vec3d& d) {
    if (face == 2 || face == 3) return enterBox(half, face, o, d);
    Hit hit = enterCylinder(half.x(), o, d);
    hit.t = within(half.norm(), hit.t, o, d);
    return hit;
}

/// Above the tip the equation describes the other half of the double cone: a ray that comes down from
/// there enters at the later root.
Hit enterCone(const Vec3d& half, int face, const Vec3d& o, const Vec3d& d) {
    const double reach = std::hypot(half.x(), 1.5 * half.y());
    if (face == 2) return {within(reach, (-0.5 * half.y() - o.y()) / d.y(), o, d), {0, -1, 0}};
    const double k = half.x() / (2.0 * half.y());
    const Vec3d w = o - Vec3d(0, 1.5 * half.y(), 0), slope(1.0, -k * k, 1.0);
    const double a = d.cwiseProduct(slope).dot(d), b = w.cwiseProduct(slope).dot(d);
    const double c = w.cwiseProduct(slope).dot(w);
    const double root = std::sqrt(std::max(b * b - a * c, 0.0));
    const double far = -b + (b > 0.0 ? -root : root);  // avoids cancellation
    const double one = far / a, other = far != 0.0 ? c / far : one;
    const double t = a > 0.0 ? std::min(one, other) : std::max(one, other);
    const Vec3d normal = (w + t * d).cwiseProduct(slope);
    return {within(reach, t, o, d), normal.normalized()};
}

Hit enterHull(const SolidMesh& mesh, int face, const Vec3d& o, const Vec3d& d) {
    const MeshPlane& plane = mesh.planes[face];
    const Vec3d n = plane.normal.cast<double>();
    const double t = (static_cast<double>(plane.offset) - n.dot(o)) / n.dot(d);
    return {within(mesh.halfSize.cast<double>().norm(), t, o, d), n};
}

/// If the ray hits no triangle of the facet: the one it misses by the least; -1: none faces the ray.
int nearlyMet(const SolidMesh& mesh, int face, const Vec3d& o, const Vec3d& d) {
    int best = -1;
    double least = 1e30;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if ((mesh.facets[i] & (kFaces - 1)) != face) continue;
        const auto& [ia, ib, ic] = mesh.triangles[i];
        const Vec3d a = mesh.vertices[ia].cast<double>(), s = o - a;
        const Vec3d e = mesh.vertices[ib].cast<double>() - a;
        const Vec3d f = mesh.vertices[ic].cast<double>() - a;
        const double det = -d.dot(e.cross(f));
        if (!(det > 0.0) || s.dot(e.cross(f)) <= 0.0) continue;
        const double u = d.dot(f.cross(s)) / det, v = d.dot(s.cross(e)) / det;
        const double outside = std::max({-u, -v, u + v - 1.0});
        if (outside < least) least = outside, best = static_cast<int>(i);
    }
    return best;
}

Hit enterMesh(const SolidMesh& mesh, int face, const Vec3d& o, const Vec3d& d) {
    FourRays rays{o.cast<float>(), {}};
    for (int i = 0; i < 3; ++i) rays.along[i] = fourOf(static_cast<float>(d[i]));
    int triangle = nearestTriangles(mesh, rays, face).triangle[0];
    if (triangle < 0) triangle = nearlyMet(mesh, face, o, d);
    const double reach = mesh.halfSize.cast<double>().norm();
    if (triangle < 0) return {within(reach, 0.0, o, d), -d.normalized()};
    const std::array<int, 3>& corners = mesh.triangles[triangle];
    const Vec3d a = mesh.vertices[corners[0]].cast<double>();
    const Vec3d n = (mesh.vertices[corners[1]].cast<double>() - a)
                        .cross(mesh.vertices[corners[2]].cast<double>() - a)
                        .normalized();
    return {within(reach, n.dot(a - o) / n.dot(d), o, d), n};
}

/// Exactly at the horizon the ray may just miss the plane.
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
        case SurfaceKind::cylinder: return enterClosed(s.half, face, o, d);
        case SurfaceKind::cone: return enterCone(s.half, face, o, d);
        case SurfaceKind::hull: return enterHull(*s.mesh, face, o, d);
        case SurfaceKind::mesh: return enterMesh(*s.mesh, face, o, d);
    }
    return {};
}

}  // namespace

Surface surfaceOf(const Solid& solid) {
    Surface s{kindOf(solid), solid.position.cast<double>(), axesOf(solid.rotation),
              solid.halfSize.cast<double>(), solid.id, solid.mesh.get()};
    if (solid.shape == SolidShape::sphere) s.half.y() = 0.0;
    if (solid.shape == SolidShape::mesh) s.half = holdingHalfSize(solid).cast<double>();
    return s;
}

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
