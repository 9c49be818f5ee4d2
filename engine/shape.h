/// What a body occupies. Every shape is centred on the body's centre of mass.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/math.h"

namespace engine {

/// plane: bounds a half space. mesh: a surface, also height fields. The others are bodies.
enum class ShapeType { sphere, box, capsule, plane, cylinder, cone, hull, compound, mesh };

struct Hull;       // shapes/hull.h
struct Mesh;       // shapes/mesh.h
struct ShapePart;  // below
using ShapeParts = std::vector<ShapePart>;  // of a compound

/// Made by one of the functions below, which stop the program where a size is not positive.
struct Shape {
    ShapeType type = ShapeType::sphere;
    double radius = 0.5;                  // m; sphere, capsule, cylinder, a cone's base
    double halfLength = 0.0;              // m, along the local y; capsule: half its core segment;
                                          // cylinder, cone: half its height
    Vec3 halfSize{0.5, 0.5, 0.5};         // m; box: half edges
    Vec3 normal{0, 1, 0};                 // plane: unit, out of the solid half space, which ends
                                          // at the body's position; static bodies only
    Vec3 origin{0, 0, 0};                 // m; hull, compound: where the origin of the points it
                                          // was made of lies, from the centre of mass
    std::shared_ptr<const Hull> hull;         // of a hull, about the centre of mass
    std::shared_ptr<const ShapeParts> parts;  // of a compound, likewise
    std::shared_ptr<const Mesh> mesh;         // of a mesh, in the axes it was given in
    double reach = 0.0;                   // m; hull, compound, mesh: as reachOf says

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
    /// Along the local y, its tip up: the base lies a quarter of the height below the origin.
    static Shape cone(double radius, double height);
    /// The convex hull of points (m). Nothing where they are flat to a ten-thousandth of their
    /// extent, are not all finite, or span more than kMostCorners corners.
    static std::optional<Shape> hullOf(std::span<const Vec3> points);
    /// Of anything but planes and meshes; parts that overlap weigh there with both their densities.
    /// At least one. `centre`: the centre of mass (m) where it is another one; the body then gives
    /// its mass and its inertia.
    static Shape compound(std::span<const ShapePart> parts,
                          const std::optional<Vec3>& centre = std::nullopt);
    /// A surface for bodies that are not dynamic: it holds from the side from which its triangles
    /// are seen counter-clockwise. Those without an area are left out; at least one must stay.
    static Shape meshOf(std::span<const Vec3> corners,
                        std::span<const std::array<int, 3>> triangles);
    /// A mesh over a grid in x and z, centred on the origin: heights (m) row after row, x running
    /// fastest, `spacing` (m) apart; at least two each way.
    static Shape heightField(int columns, int rows, double spacing,
                             std::span<const double> heights);

    static constexpr int kMostCorners = 256;  // of a hull
};

/// A piece of a compound, placed in the axes in which it is written down.
struct ShapePart {
    Shape shape;
    Pose pose;
    double density = 1.0;  // positive; times the body's own: 2 weighs twice as much as the rest
    Vec3 low{0, 0, 0}, high{0, 0, 0};  // m: bounds in the compound's axes, which compound() finds
};

/// m: the farthest of its points from the centre of mass; 0 for a plane.
double reachOf(const Shape& shape);

}  // namespace engine
