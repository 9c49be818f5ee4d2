/// Intersects a ray with a surface of a frame, in closed form and double precision.
#pragma once
#include <vector>

#include "render/frame.h"
#include "render/solid_mesh.h"

namespace render {

using Vec3d = Eigen::Vector3d;
using Mat3d = Eigen::Matrix3d;

enum class SurfaceKind { box, capsule, bar, plane, cylinder, cone, hull, mesh };

/// `half` by kind. Box: half edges. Capsule: (radius, half length of the core, radius); a length of
/// 0 is a sphere. Bar: (radius, half length, radius), along local y. Cylinder, cone: as the solids.
/// A plane passes through `at`, local y is its normal. Hull: a mesh with planes.
struct Surface {
    SurfaceKind kind = SurfaceKind::box;
    Vec3d at{0, 0, 0};                // m
    Mat3d axes = Mat3d::Identity();   // columns, world
    Vec3d half{0, 0, 0};              // m
    int id = 0;
    const SolidMesh* mesh = nullptr;  // of a hull or mesh; belongs to the frame's solid
    bool operator==(const Surface&) const = default;
};

/// A frame's surfaces, by their number in a SurfaceMap. A missing mesh becomes a box of size zero.
std::vector<Surface> surfacesOf(const Frame& frame);
Surface surfaceOf(const Solid& solid);

/// The points from + t along.
struct Ray {
    Vec3d from, along;
};

struct Hit {
    double t = 0.0;        // where the ray enters
    Vec3d normal{0, 1, 0};  // unit, world, towards the ray's origin
};

/// For a ray that is known to hit the surface in the given face (surface_map.h). A ray that barely
/// misses it, because the rasteriser rounds corners to 1/256 pixel, gets the nearest sensible
/// point. The normal of a mesh is that of its triangle, even where the mesh is drawn smooth.
Hit enter(const Surface& surface, int face, const Ray& ray);

}  // namespace render
