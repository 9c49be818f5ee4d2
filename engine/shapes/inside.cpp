#include "engine/shapes/inside.h"

#include <algorithm>

#include "engine/shapes/hull.h"

namespace engine {

bool isInside(const Shape& shape, const Vec3& p, double beyond) {
    const double r = shape.radius + beyond, h = shape.halfLength;
    const double across = p.x() * p.x() + p.z() * p.z();
    switch (shape.type) {
        case ShapeType::sphere: return p.squaredNorm() < r * r;
        case ShapeType::box: return (p.cwiseAbs() - shape.halfSize).maxCoeff() < beyond;
        case ShapeType::plane: return p.dot(shape.normal) < beyond;
        case ShapeType::capsule: {
            const double end = larger(std::abs(p.y()) - h, 0.0);
            return across + end * end < r * r;
        }
        case ShapeType::cylinder: return std::abs(p.y()) < h + beyond && across < r * r;
        case ShapeType::cone: {
            const double rim = shape.radius * (1.5 * h - p.y()) / (2.0 * h) + beyond;
            return p.y() > -0.5 * h - beyond && rim > 0.0 && across < rim * rim;
        }
        case ShapeType::hull:
            return std::ranges::all_of(shape.hull->faces, [&](const Hull::Face& face) {
                return face.normal.dot(p) < face.offset + beyond;
            });
        case ShapeType::compound:
            return std::ranges::any_of(*shape.parts, [&](const ShapePart& part) {
                return isInside(part.shape, part.pose.toLocal(p), beyond);
            });
        case ShapeType::mesh: return false;
    }
    return false;
}

}  // namespace engine
