#include "engine/forces/medium.h"

#include "engine/base/trigonometry.h"
#include "engine/dynamics/bodies.h"
#include "engine/shapes/mass.h"
#include "engine/forces/drag.h"
#include "engine/forces/submerged.h"
#include "engine/shapes/triangles.h"

namespace engine {
namespace {

bool holds(const Medium& medium, const Vec3& p) {
    return (p.array() >= medium.low.array()).all() && (p.array() <= medium.high.array()).all();
}

Vec3 dragOf(const Medium& medium, const Bodies& bodies, int body, double share, double h) {
    const Vec3 u = medium.velocity - bodies.velocities[body].linear;
    const double speed = u.norm();
    if (speed == 0.0) return Vec3::Zero();
    const double area = share * shadowOf(bodies.defs[body].shape, bodies.poses[body].rotation,
                                         u / speed);
    const double c = 0.5 * medium.density * medium.dragCoefficient * area * speed;
    return smaller(c, largestDrag(bodies, body, h)) * u;
}

/// For a convex body: half the sum of |area . d| over its surface.
double shadowOfSurface(const Shape& shape, const Vec3& d) {
    double sum = 0.0;
    forTriangles(shape, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        sum += 0.25 * std::abs((b - a).cross(c - a).dot(d));
    });
    return sum;
}

/// Ignores that parts may shield each other.
double shadowOfParts(const ShapeParts& parts, const Vec3& d) {
    double sum = 0.0;
    for (const ShapePart& part : parts) sum += shadowOf(part.shape, part.pose.rotation, d);
    return sum;
}

}  // namespace

double shadowOf(const Shape& shape, const Quat& rotation, const Vec3& direction) {
    if (shape.type == ShapeType::plane || shape.type == ShapeType::mesh) return 0.0;
    const Vec3 d = rotation.conjugate() * direction;
    const Vec3& half = shape.halfSize;
    if (shape.type == ShapeType::box)
        return 4.0 * d.cwiseAbs().dot(Vec3(half.y() * half.z(), half.z() * half.x(),
                                           half.x() * half.y()));
    if (shape.type == ShapeType::compound) return shadowOfParts(*shape.parts, d);
    if (shape.type > ShapeType::plane) return shadowOfSurface(shape, d);
    const double across = std::sqrt(larger(1.0 - d.y() * d.y(), 0.0));
    return shape.radius * (kPi * shape.radius + 4.0 * shape.halfLength * across);
}

void addLoads(const Medium& medium, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads) {
    const double g = now.gravity.norm();
    const Vec3 up = g > 0.0 ? Vec3(-now.gravity / g) : Vec3(Vec3::UnitY());
    for (const BodyId id : on) {
        if (!bodies.isAwake(id.index)) continue;
        const Pose& pose = bodies.poses[id.index];
        if (!holds(medium, pose.position)) continue;
        const Shape& shape = bodies.defs[id.index].shape;
        const SubmergedPart part = submergedPart(shape, pose, up, medium.level);
        if (part.volume <= 0.0) continue;
        const double share = part.volume / volume(shape);
        Load& load = loads[id.index];
        load.force += dragOf(medium, bodies, id.index, share, now.h);
        if (!medium.carries) continue;
        const Vec3 buoyancy = -medium.density * part.volume * now.gravity;
        load.force += buoyancy;
        load.torque += (part.centre - pose.position).cross(buoyancy);
    }
}

}  // namespace engine
