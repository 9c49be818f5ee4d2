#include "engine/collision/contact_making.h"

#include <algorithm>

#include "engine/collision/surfaces.h"

namespace engine {
namespace {

Pose seenFrom(const Pose& a, const Pose& b) {
    return {a.toLocal(b.position), a.rotation.conjugate() * b.rotation};
}

/// Rolling shapes get new points as they move.
bool isFlat(const Shape& shape) {
    switch (shape.type) {
        case ShapeType::box:
        case ShapeType::plane:
        case ShapeType::hull:
        case ShapeType::mesh: return true;
        case ShapeType::compound:
            return std::ranges::all_of(*shape.parts,
                                       [](const ShapePart& part) { return isFlat(part.shape); });
        default: return false;
    }
}

}  // namespace

Contact contactOf(const Bodies& bodies, const PairKey& pair, const Manifold& manifold,
                  Found where) {
    const Material surfaces =
        together(bodies.defs[pair.a].material, bodies.defs[pair.b].material);
    Contact contact;
    contact.a = pair.a, contact.b = pair.b;
    contact.normal = manifold.normal, contact.slideA = manifold.slideA, contact.slideB = manifold.slideB;
    contact.normalA = bodies.poses[pair.a].rotation.conjugate() * manifold.normal;
    if (where == Found::here)
        contact.seenFromA = seenFrom(bodies.poses[pair.a], bodies.poses[pair.b]);
    contact.friction = surfaces.friction;
    contact.restitution = surfaces.restitution;
    contact.rolling = surfaces.rolling;
    contact.count = manifold.count;
    for (int i = 0; i < manifold.count; ++i) {
        const ManifoldPoint& point = manifold.points[i];
        contact.points[i].anchorA = bodies.poses[pair.a].toLocal(point.onA);
        contact.points[i].anchorB = bodies.poses[pair.b].toLocal(point.onB);
        contact.points[i].feature = point.feature;
    }
    return contact;
}

bool stays(const Contact& contact, const Bodies& bodies) {
    if (!isFlat(bodies.defs[contact.a].shape) || !isFlat(bodies.defs[contact.b].shape))
        return false;
    constexpr double kWay = 5e-3, kTurn = 5e-3;  // m; sine of half the angle
    const Pose now = seenFrom(bodies.poses[contact.a], bodies.poses[contact.b]);
    const Quat turn = contact.seenFromA.rotation.conjugate() * now.rotation;
    return (now.position - contact.seenFromA.position).squaredNorm() < kWay * kWay &&
           turn.vec().squaredNorm() < kTurn * kTurn;
}

void follow(Contact& contact, const Bodies& bodies) {
    contact.slideA.setZero(), contact.slideB.setZero();
    contact.normal = bodies.poses[contact.a].rotation * contact.normalA;
}

double separationOf(const Contact& contact, int point, const Bodies& bodies) {
    const ContactPoint& p = contact.points[point];
    return contact.normal.dot(bodies.poses[contact.b].toWorld(p.anchorB) -
                              bodies.poses[contact.a].toWorld(p.anchorA));
}

double deepestOf(const Contact& contact, const Bodies& bodies) {
    double deepest = 1e300;
    for (int i = 0; i < contact.count; ++i)
        deepest = smaller(deepest, separationOf(contact, i, bodies));
    return deepest;
}

}  // namespace engine
