// The view that rays start from, and the point where a ray enters a surface, found by walking along
// the ray: slow, and without the formulas that the renderer uses.
#pragma once
#include <algorithm>
#include <cmath>

#include "render/camera.h"
#include "render/ray_surface.h"

namespace render {

constexpr double kFarthest = 30.0;  // m

inline View viewOf(const Frame& frame, int width, int height) {
    return makeView(frame.camera, static_cast<float>(width) / static_cast<float>(height));
}

/// How many times the mesh goes around a point: the sum of its triangles' solid angles over 4 pi
/// (Van Oosterom and Strackee 1983).
inline double windingNumber(const SolidMesh& mesh, const Vec3d& p) {
    double sum = 0.0;
    for (const auto& [ia, ib, ic] : mesh.triangles) {
        const Vec3d a = mesh.vertices[ia].cast<double>() - p;
        const Vec3d b = mesh.vertices[ib].cast<double>() - p;
        const Vec3d c = mesh.vertices[ic].cast<double>() - p;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        sum += std::atan2(a.dot(b.cross(c)),
                          la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la);
    }
    return sum / (2.0 * 3.14159265358979);
}

/// A bar is a tube without ends; here its ends are closed.
inline bool isInside(const Surface& s, const Vec3d& point) {
    const Vec3d p = s.axes.transpose() * (point - s.at);
    const double across = std::hypot(p.x(), p.z());
    switch (s.kind) {
        case SurfaceKind::box: return (p.cwiseAbs() - s.half).maxCoeff() < 0.0;
        case SurfaceKind::cylinder:
        case SurfaceKind::bar: return across < s.half.x() && std::abs(p.y()) < s.half.y();
        case SurfaceKind::capsule: {
            const double beyond = std::max(std::abs(p.y()) - s.half.y(), 0.0);
            return std::hypot(across, beyond) < s.half.x();
        }
        case SurfaceKind::cone: {
            const double up = 0.5 * p.y() / s.half.y() + 0.25;  // 0 at the base, 1 at the tip
            return up > 0.0 && across < s.half.x() * (1.0 - up);
        }
        case SurfaceKind::plane: return p.y() < 0.0;
        case SurfaceKind::hull:
        case SurfaceKind::mesh: return windingNumber(*s.mesh, p) > 0.5;
    }
    return false;
}

/// The distance along a ray at which it gets inside, by many small steps; kFarthest: never.
inline double walk(const Surface& s, const Vec3d& from, const Vec3d& along, double step = 5e-4,
                   double first = 0.0, double last = kFarthest) {
    for (double t = first + step; t < last; t += step)
        if (isInside(s, from + t * along)) return t;
    return kFarthest;
}

}  // namespace render
