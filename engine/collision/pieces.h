/// The convex pieces of a shape: the shape itself, the parts of a compound, or the triangles of a mesh.
/// Collision detection works on pieces; points with the same normal become one contact of the two bodies
/// (piece_contacts.h).
#pragma once
#include "engine/shapes/bounds.h"
#include "engine/collision/manifold.h"
#include "engine/shapes/mesh.h"

namespace engine {

struct Piece {
    const Shape* shape = nullptr;  // of a triangle: the whole mesh
    int number = 0;                // of the part or triangle
    bool isTriangle = false;
    const Pose* place = nullptr;   // of a part, in the body's axes

    Pose at(const Pose& body) const {
        if (!place) return body;
        return {body.toWorld(place->position), body.rotation * place->rotation};
    }
    bool isBox() const { return shape->type == ShapeType::box; }
};

inline bool isWhole(const Shape& shape) {
    return shape.type != ShapeType::compound && shape.type != ShapeType::mesh;
}
inline Piece wholeOf(const Shape& shape) { return {&shape, 0, false, nullptr}; }

/// The bounds of a piece, in world axes.
Bounds boundsOf(const Piece& piece, const Pose& body);

/// Calls visit(piece) for every piece that may be inside `within` (m, world axes).
template <class Visit>
void forPieces(const Shape& shape, const Pose& pose, const Bounds& within, Visit visit) {
    if (shape.type == ShapeType::mesh) {
        shape.mesh->query(seenFrom(pose, within), [&](int triangle) {
            visit(Piece{&shape, triangle, true, nullptr});
        });
    } else if (shape.type == ShapeType::compound) {
        const Bounds inside = seenFrom(pose, within);
        int number = 0;
        for (const ShapePart& part : *shape.parts) {
            const Piece piece{&part.shape, number++, false, &part.pose};
            if (Bounds{part.low, part.high}.overlaps(inside) && boundsOf(piece, pose).overlaps(within))
                visit(piece);
        }
    } else {
        visit(wholeOf(shape));
    }
}

/// Any piece against any other, at their bodies' poses; the normal points from a to b.
Manifold collide(const Piece& a, const Pose& bodyA, const Piece& b, const Pose& bodyB,
                 double margin);

}  // namespace engine
