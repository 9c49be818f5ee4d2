/// Box against box: the axis of least penetration among 15 (3 + 3 face normals, 9 edge pairs), then
/// either a face clipped by the other's sides, with at most four points kept, or one point on two
/// edges. (Gottschalk 1996 for the axes; Sutherland and Hodgman 1974 for the clipping.)
#include "engine/collision/collide.h"
#include "engine/collision/axis_bonus.h"
#include "engine/collision/clip.h"
#include "engine/collision/oriented_box.h"

namespace engine {
namespace {

struct BestAxis {
    double separation = -1e300;
    Vec3 normal = Vec3::Zero();  // from a to b
    int i = -1, j = -1;          // face: axis i; edges: axis i of a, axis j of b
};

/// The separation along n (unit, either sign), oriented from a to b.
BestAxis along(const Vec3& n, const OrientedBox& a, const OrientedBox& b, int i, int j) {
    const double distance = n.dot(b.centre - a.centre);
    const Vec3 outward = distance < 0.0 ? Vec3(-n) : n;
    return {std::abs(distance) - a.extent(n) - b.extent(n), outward, i, j};
}

BestAxis bestFace(const OrientedBox& owner, const OrientedBox& a, const OrientedBox& b) {
    BestAxis best;
    for (int i = 0; i < 3; ++i) {
        const BestAxis face = along(owner.axes.col(i), a, b, i, -1);
        if (face.separation > best.separation) best = face;
    }
    return best;
}

/// Exact where they are more than `least` (m) apart along one of them.
BestAxis bestEdges(const OrientedBox& a, const OrientedBox& b, double least) {
    BestAxis best;
    const EdgeAxes axes(a, b);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            if (!axes.mayExceed(least, i, j)) continue;
            const Vec3 n = a.axes.col(i).cross(b.axes.col(j));
            const double length = n.norm();
            if (length < 1e-3) continue;  // parallel edges: the face normals cover them
            const BestAxis edges = along(n / length, a, b, i, j);
            if (edges.separation > best.separation) best = edges;
        }
    return best;
}

/// The reference face is on `reference`, with outward normal n. The face of the other box most
/// opposed to it is clipped by its four sides.
void clipFaces(const OrientedBox& reference, int axis, const Vec3& n, const OrientedBox& other,
               double margin, bool flipped, Manifold& m) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Vec3 against = other.axes.transpose() * n;
    int incident = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(against[i]) > std::abs(against[incident])) incident = i;
    const double side = against[incident] > 0.0 ? -1.0 : 1.0;

    Polygon polygon = faceOf(other.axes, other.centre, other.half, incident, side);
    for (int i = 0; i < 4; ++i) {
        const int k = i < 2 ? u : v;
        const Vec3 outward = (i % 2 == 0 ? 1.0 : -1.0) * reference.axes.col(k);
        clip(polygon, outward, outward.dot(reference.centre) + reference.half[k], 4 + i);
    }
    const double faceHeight = n.dot(reference.centre) + reference.half[axis];
    const bool positive = n.dot(reference.axes.col(axis)) > 0.0;
    const int face = ((flipped ? 1 : 0) * 6 + 2 * axis + (positive ? 1 : 0)) * 6 +
                     2 * incident + (side > 0.0 ? 1 : 0);
    ClippedPoints<8> points(polygon, n, faceHeight, margin);
    points.keepFour(n);
    for (int i = 0; i < points.count; ++i) {
        const Vec3& onOther = points.position[i];
        const Vec3 onReference = onOther - points.separation[i] * n;
        const int feature = face * 64 + points.label[i];
        if (flipped)
            m.add(onOther, onReference, feature);
        else
            m.add(onReference, onOther, feature);
    }
}

/// The point of the box's edge along axis k that lies farthest along n: the middle of that edge.
Vec3 supportingEdge(const OrientedBox& box, int k, const Vec3& n, int& corner) {
    Vec3 p = box.centre;
    corner = 0;
    for (int i = 0; i < 3; ++i) {
        if (i == k) continue;
        const double sign = box.axes.col(i).dot(n) > 0.0 ? 1.0 : -1.0;
        p += sign * box.half[i] * box.axes.col(i);
        corner = 2 * corner + (sign > 0.0 ? 1 : 0);
    }
    return p;
}

void touchEdges(const OrientedBox& a, const OrientedBox& b, const BestAxis& best, Manifold& m) {
    int cornerA = 0, cornerB = 0;
    const Vec3 p = supportingEdge(a, best.i, best.normal, cornerA);
    const Vec3 q = supportingEdge(b, best.j, -best.normal, cornerB);
    const Vec3 d = a.axes.col(best.i), e = b.axes.col(best.j), r = q - p;
    const double de = d.dot(e), determinant = 1.0 - de * de;  // > 0: the edges are not parallel
    const double s = (r.dot(d) - de * r.dot(e)) / determinant;
    const double t = (de * r.dot(d) - r.dot(e)) / determinant;
    const int feature = 12 * 6 * 64 + ((best.i * 3 + best.j) * 4 + cornerA) * 4 + cornerB;
    const Vec3 onA = p + clamped(s, -a.half[best.i], a.half[best.i]) * d;
    const Vec3 onB = q + clamped(t, -b.half[best.j], b.half[best.j]) * e;
    // Clamping may move the two points off the normal; the separation along it is that of the axis.
    const Vec3 middle = 0.5 * (onA + onB);
    const Vec3 reach = 0.5 * best.separation * best.normal;
    m.add(middle - reach, middle + reach, feature);
}

void touchFaces(const OrientedBox& a, const OrientedBox& b, const BestAxis& faceA,
                const BestAxis& faceB, double margin, Manifold& m) {
    const bool byB = faceB.separation > faceA.separation + kFaceBonus;
    const BestAxis& face = byB ? faceB : faceA;
    m.normal = face.normal;
    if (byB)
        clipFaces(b, face.i, -face.normal, a, margin, true, m);
    else
        clipFaces(a, face.i, face.normal, b, margin, false, m);
}

}  // namespace

Manifold collideBoxBox(const Shape& shapeA, const Pose& poseA, const Shape& shapeB,
                       const Pose& poseB, double margin) {
    Manifold m;
    const OrientedBox a(shapeA, poseA), b(shapeB, poseB);
    const BestAxis faceA = bestFace(a, a, b);
    if (faceA.separation > margin) return m;
    const BestAxis faceB = bestFace(b, a, b);
    if (faceB.separation > margin) return m;
    const double beyondFaces = larger(faceA.separation, faceB.separation) + kEdgeBonus;
    const BestAxis edges = bestEdges(a, b, beyondFaces);
    if (edges.separation > margin) return m;

    if (edges.separation > beyondFaces) {
        m.normal = edges.normal;
        touchEdges(a, b, edges, m);
    } else {
        touchFaces(a, b, faceA, faceB, margin, m);
    }
    return m;
}

Manifold collideBoxFaces(const Shape& shapeA, const Pose& poseA, const Shape& shapeB,
                         const Pose& poseB, double margin) {
    Manifold m;
    const OrientedBox a(shapeA, poseA), b(shapeB, poseB);
    touchFaces(a, b, bestFace(a, a, b), bestFace(b, a, b), margin, m);
    return m;
}

}  // namespace engine
