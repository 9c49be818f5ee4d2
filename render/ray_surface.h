/// Where a ray meets a surface of a frame, in closed form and double precision.
#pragma once
#include <vector>

#include "render/frame.h"
#include "render/solid_mesh.h"

namespace render {

using Vec3d = Eigen::Vector3d;
using Mat3d = Eigen::Matrix3d;

enum class SurfaceKind { box, capsule, bar, plane, cylinder, cone, hull, mesh };

/// Box: half edges. Capsule: (radius, half length of the core, radius), a sphere when that is 0.
/// Bar: (radius, half length, radius), its core along its y. Plane: through `at`, its y the normal.
/// Cylinder, cone: as the solids. Hull: a mesh with planes.
struct Surface {
    SurfaceKind kind = SurfaceKind::box;
    Vec3d at{0, 0, 0};                // m
    Mat3d axes = Mat3d::Identity();   // columns, world
    Vec3d half{0, 0, 0};              // m
    int id = 0;
    const SolidMesh* mesh = nullptr;  // of a hull or mesh; belongs to the frame's solid
    bool operator==(const Surface&) const = default;
};

/// A frame's surfaces, by their number in a SurfaceMap. A mesh that is not there is a box of no
/// size.
std::vector<Surface> surfacesOf(const Frame& frame);
Surface surfaceOf(const Solid& solid);

/// Points from + t along.
struct Ray {
    Vec3d from, along;
};

struct Hit {
    double t = 0.0;        // where the ray enters
    Vec3d normal{0, 1, 0};  // unit, world, towards the ray's beginning
};

/// For a ray that is known to meet the surface in the given face (surface_map.h). One that passes
/// it by a hair, as a rasteriser with its corners on a grid of 1/256 pixel lets it, gets the
/// nearest sensible point. The normal of a mesh is its triangle's, however softly it is drawn.
Hit enter(const Surface& surface, int face, const Ray& ray);

}  // namespace render
