#include "engine/collision/pieces.h"

namespace engine {

Bounds boundsOf(const Piece& piece, const Pose& body) {
    if (!piece.isTriangle) return boundsOf(*piece.shape, piece.at(body));
    const Mesh& mesh = *piece.shape->mesh;
    Bounds bounds{Vec3::Constant(1e300), Vec3::Constant(-1e300)};
    for (const int c : mesh.triangles[piece.number].corners) {
        const Vec3 p = body.toWorld(mesh.corners[c]);
        bounds = bounds.with({p, p});
    }
    return bounds;
}

}  // namespace engine
