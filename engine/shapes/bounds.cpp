#include "engine/shapes/bounds.h"

#include "engine/shapes/hull.h"
#include "engine/shapes/mesh.h"

namespace engine {
namespace {

/// Half the bounds of a disc perpendicular to `axis`.
Vec3 discReach(const Vec3& axis, double radius) {
    return radius * (Vec3::Ones() - axis.cwiseProduct(axis)).cwiseMax(0.0).cwiseSqrt();
}

Bounds roundBounds(const Shape& shape, const Pose& pose) {
    const Vec3 axis = pose.rotation * Vec3::UnitY();
    const Vec3 rim = discReach(axis, shape.radius);
    const bool cone = shape.type == ShapeType::cone;
    const Vec3 base = pose.position - (cone ? 0.5 : 1.0) * shape.halfLength * axis;
    const Vec3 top = pose.position + (cone ? 1.5 : 1.0) * shape.halfLength * axis;
    const Vec3 topRim = cone ? Vec3(Vec3::Zero()) : rim;
    return Bounds{base - rim, base + rim}.with({top - topRim, top + topRim});
}

Bounds hullBounds(const Hull& hull, const Pose& pose) {
    const Mat3 turn = pose.rotation.toRotationMatrix();
    Bounds bounds{Vec3::Constant(1e300), Vec3::Constant(-1e300)};
    for (const Vec3& corner : hull.corners) {
        const Vec3 p = pose.position + turn * corner;
        bounds = bounds.with({p, p});
    }
    return bounds;
}

Bounds compoundBounds(const ShapeParts& parts, const Pose& pose) {
    Bounds bounds{Vec3::Constant(1e300), Vec3::Constant(-1e300)};
    for (const ShapePart& part : parts)
        bounds = bounds.with(boundsOf(part.shape, {pose.toWorld(part.pose.position),
                                                   pose.rotation * part.pose.rotation}));
    return bounds;
}

}  // namespace

Bounds boundsOf(const Shape& shape, const Pose& pose) {
    Vec3 reach = Vec3::Constant(shape.radius);
    switch (shape.type) {
        case ShapeType::box:
            reach = pose.rotation.toRotationMatrix().cwiseAbs() * shape.halfSize;
            break;
        case ShapeType::capsule:
            reach += (pose.rotation * Vec3(0.0, shape.halfLength, 0.0)).cwiseAbs();
            break;
        case ShapeType::cylinder:
        case ShapeType::cone: return roundBounds(shape, pose);
        case ShapeType::hull: return hullBounds(*shape.hull, pose);
        case ShapeType::compound: return compoundBounds(*shape.parts, pose);
        case ShapeType::mesh: {
            const Bounds& own = shape.mesh->bounds();
            const Mat3 turn = pose.rotation.toRotationMatrix();
            const Vec3 middle = pose.position + turn * (0.5 * (own.low + own.high));
            const Vec3 half = turn.cwiseAbs() * (0.5 * (own.high - own.low));
            return {middle - half, middle + half};
        }
        case ShapeType::sphere:
        case ShapeType::plane: break;
    }
    return {pose.position - reach, pose.position + reach};
}

Bounds seenFrom(const Pose& pose, const Bounds& world) {
    const Vec3 middle = pose.toLocal(0.5 * (world.low + world.high));
    const Vec3 half = pose.rotation.toRotationMatrix().transpose().cwiseAbs() *
                      (0.5 * (world.high - world.low));
    return {middle - half, middle + half};
}

}  // namespace engine
