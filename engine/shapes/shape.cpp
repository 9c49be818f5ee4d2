#include "engine/shape.h"

#include "engine/base/check.h"
#include "engine/shapes/bounds.h"
#include "engine/shapes/hull.h"
#include "engine/shapes/mass.h"
#include "engine/shapes/mesh.h"

namespace engine {
namespace {

/// A shape of revolution about the local y.
Shape roundShape(ShapeType type, double radius, double halfLength) {
    Shape s;
    s.type = type;
    s.radius = radius;
    s.halfLength = halfLength;
    return s;
}

template <class Points>
double farthest(const Points& points) {
    double square = 0.0;
    for (const Vec3& p : points) square = larger(square, p.squaredNorm());
    return std::sqrt(square);
}

/// False for NaN and infinity.
bool isLength(double x) { return x > 0.0 && std::isfinite(x); }

void checkPart(const ShapePart& part) {
    const Shape& shape = part.shape;
    ENGINE_CHECK(shape.type != ShapeType::plane && shape.type != ShapeType::mesh,
                 "a compound cannot contain planes or meshes");
    ENGINE_CHECK((shape.type != ShapeType::compound || shape.parts) &&
                     (shape.type != ShapeType::hull || shape.hull),
                 "make a part's shape with a function of Shape");
    ENGINE_CHECK(part.density > 0.0 && std::isfinite(part.density),
                 "a part of a compound needs a positive density");
    ENGINE_CHECK(part.pose.position.allFinite() && isLength(part.pose.rotation.norm()),
                 "a part of a compound needs a finite place and a nonzero quaternion");
}

double farthestOf(const ShapeParts& parts) {
    double most = 0.0;
    for (const ShapePart& part : parts)
        most = larger(most, part.pose.position.norm() + reachOf(part.shape));
    return most;
}

}  // namespace

Shape Shape::sphere(double radius) {
    ENGINE_CHECK(isLength(radius), "a sphere needs a positive radius");
    return roundShape(ShapeType::sphere, radius, 0.0);
}

Shape Shape::box(const Vec3& size) {
    ENGINE_CHECK(isLength(size.x()) && isLength(size.y()) && isLength(size.z()),
                 "a box needs three positive edges");
    Shape s;
    s.type = ShapeType::box;
    s.halfSize = 0.5 * size;
    return s;
}

Shape Shape::capsule(double radius, double height) {
    ENGINE_CHECK(isLength(radius) && isLength(height) && height >= 2.0 * radius,
                 "a capsule needs a positive radius and a height of at least twice that");
    return roundShape(ShapeType::capsule, radius, 0.5 * height - radius);
}

Shape Shape::plane(const Vec3& normal) {
    const double length = normal.norm();
    ENGINE_CHECK(isLength(length), "a plane needs a nonzero normal");
    Shape s;
    s.type = ShapeType::plane;
    s.normal = normal / length;
    return s;
}

Shape Shape::cylinder(double radius, double height) {
    ENGINE_CHECK(isLength(radius) && isLength(height),
                 "a cylinder needs a positive radius and height");
    return roundShape(ShapeType::cylinder, radius, 0.5 * height);
}

Shape Shape::cone(double radius, double height) {
    ENGINE_CHECK(isLength(radius) && isLength(height), "a cone needs a positive radius and height");
    return roundShape(ShapeType::cone, radius, 0.5 * height);
}

std::optional<Shape> Shape::hullOf(std::span<const Vec3> points) {
    std::optional<Hull> hull = convexHull(points);
    if (!hull) return std::nullopt;
    // Moves the first corner to the origin: far from the origin, the integrals lose digits.
    const Vec3 near = hull->corners[0];
    const auto moveBy = [&](const Vec3& way) {
        for (Vec3& corner : hull->corners) corner += way;
        for (Hull::Face& face : hull->faces) {
            face.offset = -1e300;
            for (const int i : face.corners)
                face.offset = larger(face.offset, face.normal.dot(hull->corners[i]));
        }
    };
    moveBy(-near);
    const VolumeIntegrals sum = integralsOf(*hull);
    const Vec3 centre = sum.first / sum.volume;
    moveBy(-centre);
    hull->cornerLanes = CornerLanes(hull->corners);
    for (const Hull::Face& face : hull->faces) hull->faceLanes.add(face.normal, face.offset);
    Shape s;
    s.type = ShapeType::hull;
    s.origin = -near - centre;
    s.reach = farthest(hull->corners);
    s.hull = std::make_shared<const Hull>(*std::move(hull));
    return s;
}

Shape Shape::compound(std::span<const ShapePart> parts, const std::optional<Vec3>& given) {
    ENGINE_CHECK(!parts.empty(), "a compound needs at least one part");
    ENGINE_CHECK(!given || given->allFinite(), "a centre of mass must be finite");
    auto placed = std::make_shared<ShapeParts>();
    for (const ShapePart& part : parts) {
        checkPart(part);
        const Quat turn = part.pose.rotation.normalized();
        if (part.shape.type != ShapeType::compound) {
            placed->push_back({part.shape, {part.pose.position, turn}, part.density});
            continue;
        }
        for (const ShapePart& inner : *part.shape.parts)
            placed->push_back({inner.shape,
                               {part.pose.toWorld(inner.pose.position), turn * inner.pose.rotation},
                               part.density * inner.density});
    }
    const VolumeIntegrals sum = integralsOf(*placed);
    const Vec3 centre = given ? *given : Vec3(sum.first / sum.volume);
    for (ShapePart& part : *placed) {
        part.pose.position -= centre;
        const Bounds bounds = boundsOf(part.shape, part.pose);
        part.low = bounds.low, part.high = bounds.high;
    }
    Shape s;
    s.type = ShapeType::compound;
    s.origin = -centre;
    s.reach = farthestOf(*placed);
    s.parts = std::move(placed);
    return s;
}

Shape Shape::meshOf(std::span<const Vec3> corners,
                    std::span<const std::array<int, 3>> triangles) {
    for (const std::array<int, 3>& triangle : triangles)
        for (const int corner : triangle)
            ENGINE_CHECK(corner >= 0 && corner < static_cast<int>(corners.size()) &&
                             corners[corner].allFinite(),
                         "a triangle needs three corners of its mesh, all finite");
    auto mesh = std::make_shared<const Mesh>(makeMesh(corners, triangles));
    ENGINE_CHECK(!mesh->triangles.empty(), "a mesh needs a triangle with an area");
    Shape s;
    s.type = ShapeType::mesh;
    s.reach = farthest(mesh->corners);
    s.mesh = std::move(mesh);
    return s;
}

Shape Shape::heightField(int columns, int rows, double spacing, std::span<const double> heights) {
    ENGINE_CHECK(columns >= 2 && rows >= 2 && isLength(spacing) &&
                     heights.size() == static_cast<std::size_t>(columns) * rows,
                 "a height field needs two columns, two rows, and a height for each of its points");
    std::vector<Vec3> corners;
    std::vector<std::array<int, 3>> triangles;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            corners.push_back({spacing * (i - 0.5 * (columns - 1)), heights[j * columns + i],
                               spacing * (j - 0.5 * (rows - 1))});
    for (int j = 0; j + 1 < rows; ++j)
        for (int i = 0; i + 1 < columns; ++i) {
            const int c = j * columns + i, d = c + columns;
            triangles.push_back({c, d, c + 1});
            triangles.push_back({c + 1, d, d + 1});
        }
    return meshOf(corners, triangles);
}

double reachOf(const Shape& shape) {
    const double r = shape.radius, h = shape.halfLength;
    switch (shape.type) {
        case ShapeType::sphere: return r;
        case ShapeType::box: return shape.halfSize.norm();
        case ShapeType::capsule: return h + r;
        case ShapeType::cylinder: return std::sqrt(r * r + h * h);
        case ShapeType::cone: return larger(1.5 * h, std::sqrt(r * r + 0.25 * h * h));
        case ShapeType::hull:
        case ShapeType::compound:
        case ShapeType::mesh: return shape.reach;
        case ShapeType::plane: return 0.0;
    }
    return 0.0;
}

}  // namespace engine
