/// The shape of a body, centred on its centre of mass.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/math.h"

namespace engine {

/// plane: bounds a half space. mesh: a surface, also for height fields. The others are solids.
enum class ShapeType { sphere, box, capsule, plane, cylinder, cone, hull, compound, mesh };

struct Hull;       // shapes/hull.h
struct Mesh;       // shapes/mesh.h
struct ShapePart;  // below
using ShapeParts = std::vector<ShapePart>;  // of a compound

/// Made by the functions below, which stop the program if a size is not positive.
struct Shape {
    ShapeType type = ShapeType::sphere;
    double radius = 0.5;                  // m; sphere, capsule, cylinder, a cone's base
    double halfLength = 0.0;              // m, along the local y; capsule: half its core segment;
                                          // cylinder, cone: half its height
    Vec3 halfSize{0.5, 0.5, 0.5};         // m; box: half edges
    Vec3 normal{0, 1, 0};                 // plane: unit, out of the solid half space, bounded
                                          // at the body's position; not for dynamic bodies
    Vec3 origin{0, 0, 0};                 // m; hull, compound: the origin of the points it was
                                          // made of, relative to the centre of mass
    std::shared_ptr<const Hull> hull;         // of a hull, about the centre of mass
    std::shared_ptr<const ShapeParts> parts;  // of a compound, the same
    std::shared_ptr<const Mesh> mesh;         // of a mesh, in its original axes
    double reach = 0.0;                   // m; hull, compound, mesh: see reachOf

    /// `radius`: m.
    static Shape sphere(double radius);
    /// `size`: the full edges, m.
    static Shape box(const Vec3& size);
    /// `height`: from tip to tip, m; at least twice the radius.
    static Shape capsule(double radius, double height);
    /// `normal`: any length but zero.
    static Shape plane(const Vec3& normal);
    /// Along the local y.
    static Shape cylinder(double radius, double height);
    /// Along the local y, tip up; the base is a quarter of the height below the origin.
    static Shape cone(double radius, double height);
    /// The convex hull of points (m). Null if they are flat to a ten-thousandth of their extent,
    /// are not all finite, or span more than kMostCorners corners.
    static std::optional<Shape> hullOf(std::span<const Vec3> points);
    /// One or more parts of any type except planes and meshes; overlapping parts both contribute
    /// their densities. `centre`: overrides the centre of mass (m); the body must then specify its
    /// mass and inertia.
    static Shape compound(std::span<const ShapePart> parts,
                          const std::optional<Vec3>& centre = std::nullopt);
    /// A surface for bodies that are not dynamic. It is solid from the side from which its
    /// triangles are counter-clockwise. Triangles without an area are omitted; at least one must
    /// remain.
    static Shape meshOf(std::span<const Vec3> corners,
                        std::span<const std::array<int, 3>> triangles);
    /// A mesh over a grid in x and z, centred on the origin: heights (m) row by row, x changing
    /// fastest, `spacing` (m) apart; at least two columns and rows.
    static Shape heightField(int columns, int rows, double spacing,
                             std::span<const double> heights);

    static constexpr int kMostCorners = 256;  // of a hull
};

/// A part of a compound, placed in the compound's original axes.
struct ShapePart {
    Shape shape;
    Pose pose;
    double density = 1.0;  // positive, relative to the body's density
    Vec3 low{0, 0, 0}, high{0, 0, 0};  // m: bounds in the compound's axes, set by compound()
};

/// The largest distance of a point from the centre of mass, m; 0 for a plane.
double reachOf(const Shape& shape);

}  // namespace engine
