/// The surface of a solid shape as triangles, for sums over it. Polyhedra are exact; circles are polygons of
/// 24 corners, with 1.1 % less area.
#pragma once
#include "engine/base/trigonometry.h"
#include "engine/shape.h"
#include "engine/shapes/hull.h"

namespace engine {

/// Calls visit(a, b, c) for the triangles of a hull, a cylinder or a cone, in the shape's axes (m),
/// counter-clockwise from outside.
template <class Visit>
void forTriangles(const Shape& shape, Visit visit) {
    if (shape.type == ShapeType::hull) {
        for (const Hull::Face& face : shape.hull->faces)
            for (std::size_t i = 2; i < face.corners.size(); ++i)
                visit(shape.hull->corners[face.corners[0]],
                      shape.hull->corners[face.corners[i - 1]],
                      shape.hull->corners[face.corners[i]]);
        return;
    }
    constexpr int kSides = 24;
    const bool cone = shape.type == ShapeType::cone;
    const Vec3 base(0.0, (cone ? -0.5 : -1.0) * shape.halfLength, 0.0);
    const Vec3 top(0.0, (cone ? 1.5 : 1.0) * shape.halfLength, 0.0);
    const double c = cosine(2.0 * kPi / kSides), s = sine(2.0 * kPi / kSides);
    const Vec3 up = top - base;
    Vec3 p(shape.radius, 0.0, 0.0);
    for (int i = 0; i < kSides; ++i) {  // counter-clockwise seen from below
        const Vec3 q(c * p.x() - s * p.z(), 0.0, s * p.x() + c * p.z());
        visit(base, Vec3(base + p), Vec3(base + q));
        if (cone) {
            visit(Vec3(base + q), Vec3(base + p), top);
        } else {
            visit(Vec3(base + q), Vec3(base + p), Vec3(base + p + up));
            visit(Vec3(base + q), Vec3(base + p + up), Vec3(base + q + up));
            visit(top, Vec3(top + q), Vec3(top + p));
        }
        p = q;
    }
}

}  // namespace engine
