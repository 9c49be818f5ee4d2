#include "engine/shape.h"

#include "engine/base/check.h"

namespace engine {

Shape Shape::sphere(double radius) {
    ENGINE_CHECK(radius > 0.0, "a sphere needs a positive radius");
    Shape s;
    s.type = ShapeType::sphere;
    s.radius = radius;
    return s;
}

Shape Shape::box(const Vec3& size) {
    ENGINE_CHECK(size.minCoeff() > 0.0, "a box needs three positive edges");
    Shape s;
    s.type = ShapeType::box;
    s.halfSize = 0.5 * size;
    return s;
}

Shape Shape::capsule(double radius, double height) {
    ENGINE_CHECK(radius > 0.0 && height >= 2.0 * radius,
                 "a capsule needs a positive radius and a height of at least twice that");
    Shape s;
    s.type = ShapeType::capsule;
    s.radius = radius;
    s.halfLength = 0.5 * height - radius;
    return s;
}

Shape Shape::plane(const Vec3& normal) {
    const double length = normal.norm();
    ENGINE_CHECK(length > 0.0, "a plane needs a normal that is not zero");
    Shape s;
    s.type = ShapeType::plane;
    s.normal = normal / length;
    return s;
}

}  // namespace engine
