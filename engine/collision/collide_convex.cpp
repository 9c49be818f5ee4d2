#include "engine/collision/collide_convex.h"

#include <algorithm>

#include "engine/collision/axis_bonus.h"
#include "engine/collision/way_out.h"

namespace engine {
namespace {

constexpr double kBeside = 5e-4;  // m: a point this far outside a face's sides still lies on it
constexpr int kLine = 1 << 30;    // features that belong to no face

struct FaceAxis {
    double separation = -1e300;  // m, radii included
    int face = -1;
    bool ofB = false;
};

/// The face of `owner` with the largest separation from `other`. Any single point of `other` gives an upper
/// bound of it, so the face with the largest bound is evaluated next, until none may be better than the best so
/// far. Ends at the first separation beyond `margin`.
FaceAxis bestFaceOf(const Convex& owner, const Convex& other, bool ofB, double margin) {
    const double radii = owner.radius() + other.radius();
    constexpr double kOut = -1e300;  // the bound of faces that do not count or have been evaluated
    std::array<double, Convex::kMostFaces> bounds;
    const int count = owner.faceCount();
    FaceAxis best;
    if (count == 0) return best;
    std::fill_n(bounds.begin(), count, 1e300);
    if (count % FaceLanes::kAtOnce != 0) bounds[count] = kOut;
    if (other.isTriangle()) {
        const Vec3 front = owner.localOf(other.front());
        for (int i = 0; i < count; ++i)
            if (owner.plane(i).normal.dot(front) > 1e-3) bounds[i] = kOut;
    }
    const Vec3 start = owner.toLocal(other.support(owner.centre() - other.centre()));
    int next = owner.lowerBounds(start, radii, bounds.data());
    while (bounds[next] > best.separation && best.separation <= margin) {
        const Plane face = owner.plane(next);
        const Vec3 nearest = owner.toLocal(other.support(-owner.turned(face.normal)));
        const double separation = face.normal.dot(nearest) - face.offset - radii;
        if (separation > best.separation) best = {separation, next, ofB};
        bounds[next] = kOut;
        next = owner.lowerBounds(nearest, radii, bounds.data());
    }
    return best;
}

FaceAxis bestFace(const Convex& a, const Convex& b, double margin) {
    FaceAxis best = bestFaceOf(a, b, false, margin);
    if (best.separation > margin) return best;
    const FaceAxis ofB = bestFaceOf(b, a, true, margin);
    if (ofB.separation > best.separation + kFaceBonus) best = ofB;
    return best;
}

/// A side plane of a face, through two adjacent corners; the normal points out.
struct Side {
    Vec3 normal;
    double offset;
};
Side sideOf(const Feature& face, int i, const Vec3& n) {
    const Vec3& from = face.corner[i];
    const Vec3 out = (face.corner[i + 1 < face.count ? i + 1 : 0] - from).cross(n).normalized();
    return {out, out.dot(from)};
}

/// Clips a segment or a point by the sides of a face; false: nothing is left.
bool clipLine(Feature& line, const Feature& face, const Vec3& n) {
    for (int i = 0; i < face.count; ++i) {
        const Side side = sideOf(face, i, n);
        double height[2];
        for (int k = 0; k < line.count; ++k)
            height[k] = side.normal.dot(line.corner[k]) - side.offset;
        if (line.count == 1) {
            if (height[0] > kBeside) return false;
            continue;
        }
        if (height[0] > kBeside && height[1] > kBeside) return false;
        const Vec3 way = line.corner[1] - line.corner[0];
        for (int k = 0; k < 2; ++k)
            if (height[k] > kBeside)
                line.corner[k] = line.corner[0] +
                                 clamped(height[0] / (height[0] - height[1]), 0.0, 1.0) * way;
    }
    return true;
}

/// The part of `other` that lies against face `number` of `owner`.
Manifold clipToFace(const Convex& owner, int number, const Convex& other, bool ofB,
                    double margin) {
    Manifold m;
    const Vec3 n = owner.faceNormal(number);
    m.normal = ofB ? Vec3(-n) : n;
    const Feature face = owner.face(number);
    int incident = 0;
    Feature feature = other.towards(-n, incident);
    if (feature.count <= 2) {
        if (!clipLine(feature, face, n)) return m;
    } else {
        for (int i = 0; i < face.count; ++i) {
            const Side side = sideOf(face, i, n);
            clip(feature, side.normal, side.offset, kMostClipped / 2 + i);
        }
    }
    const double height = n.dot(face.corner[0]) + other.radius();
    ClippedPoints<kMostClipped> points(feature, n, height, margin);
    points.keepFour(n);
    const int name = ((ofB ? 300 : 0) + number) * 300 + incident;
    for (int i = 0; i < points.count; ++i) {
        const Vec3 onOther = points.position[i] - other.radius() * n;
        const Vec3 onOwner = onOther - points.separation[i] * n;
        m.add(ofB ? onOther : onOwner, ofB ? onOwner : onOther,
              name * kMostClipped * kMostClipped + points.label[i]);
    }
    return m;
}

Manifold clipToFace(const Convex& a, const Convex& b, const FaceAxis& axis, double margin) {
    return axis.ofB ? clipToFace(b, axis.face, a, true, margin)
                    : clipToFace(a, axis.face, b, false, margin);
}

void addAlong(Manifold& m, const Vec3& p, const Vec3& q, double radiusA, double radiusB,
              double margin, int feature) {
    const double separation = m.normal.dot(q - p) - radiusA - radiusB;
    if (separation > margin) return;
    // The two points may be off the normal; the separation along it is that of the axis.
    const Vec3 middle = 0.5 * (p + radiusA * m.normal + q - radiusB * m.normal);
    const Vec3 reach = 0.5 * separation * m.normal;
    m.add(middle - reach, middle + reach, feature);
}

double deepestOf(const Manifold& m) {
    double deepest = kFar;
    for (int i = 0; i < m.count; ++i) deepest = smaller(deepest, m.separation(i));
    return deepest;
}

/// Two points where two lines run along each other. No points: they do not, or the first touch is elsewhere.
Manifold alongLines(const Convex& a, const Convex& b, const WayOut& out, double margin) {
    Manifold m;
    m.normal = out.normal;
    Segment onA, onB;
    double from = 0.0, to = 0.0;
    if (!a.line(m.normal, onA) || !b.line(-m.normal, onB) ||
        !nearlyParallel(onA.half, onB.half) || !overlap(onA, onB, from, to))
        return m;
    for (const int end : {0, 1}) {
        const Vec3 p = onA.at(end == 0 ? from : to);
        addAlong(m, p, onB.at(closestOn(onB, p)), a.radius(), b.radius(), margin,
                 kLine + 1 + end);
    }
    const double separation = out.separation - a.radius() - b.radius();
    if (deepestOf(m) > separation + kEdgeBonus) m.count = 0;
    return m;
}

Manifold collideTwo(const Convex& a, const Convex& b, double margin) {
    const FaceAxis face = bestFace(a, b, margin);
    if (face.separation > margin) return {};
    Manifold onFace;
    if (face.face >= 0) onFace = clipToFace(a, b, face, margin);
    const double deepest = deepestOf(onFace);
    // The first touch is over the face: no other normal is better by more than the bonus.
    const bool over = deepest < face.separation + kBeside;
    if (over && face.separation > -kEdgeBonus) return onFace;
    const WayOut out = wayOut(a, b, margin + a.radius() + b.radius());
    const double separation = out.separation - a.radius() - b.radius();
    if (separation > margin) return {};
    if (separation < face.separation + kEdgeBonus && deepest < separation + kEdgeBonus)
        return onFace;
    Manifold m = alongLines(a, b, out, margin);
    if (m.count == 0)
        addAlong(m, out.onA, out.onB, a.radius(), b.radius(), margin, kLine);
    return m;
}

/// Against a triangle a. Edges that are not sharp, and the back, act through the front: only where the piece
/// is over it, and has not sunk below it by more than a quarter of its size. A piece over no front, between
/// the normals of a slightly bent ridge, touches the edge after all.
Manifold collideTriangle(const Convex& a, const Convex& b, double margin) {
    const double separation = separationOfCores(a, b, a.front()) - b.radius();
    if (separation > margin || apartFromTriangle(a, b) > margin + kBeside) return {};
    const bool sunk = separation < -1.25 * (b.reach() + b.radius());
    Manifold m;
    if (!a.isSmooth()) {
        m = collideTwo(a, b, margin);
        if (m.count == 0) return m;
        const double along = m.normal.dot(a.front());
        if (along > 1.0 - 1e-9 || (along > -1e-2 && !a.isSmoothAt(m.points[0].onA))) return m;
    }
    if (sunk) return {};
    const Manifold onFront = clipToFace(a, 0, b, false, margin);
    if (onFront.count > 0 || !a.isAnySlight()) return onFront;
    if (a.isSmooth()) m = collideTwo(a, b, margin);
    return m.count > 0 && a.isTopAt(m.points[0].onA, m.normal) ? m : Manifold{};
}

}  // namespace

Manifold collideConvex(const Convex& a, const Convex& b, double margin) {
    if (a.isTriangle()) return collideTriangle(a, b, margin);
    if (!b.isTriangle()) return collideTwo(a, b, margin);
    Manifold m = collideTriangle(b, a, margin);
    m.flip();
    return m;
}

Manifold collideConvexPlane(const Convex& a, const Shape& plane, const Pose& pose, double margin) {
    Manifold m;
    const Vec3 up = pose.rotation * plane.normal;
    m.normal = -up;
    const double height = up.dot(pose.position) + a.radius();
    if (up.dot(a.support(-up)) - height > margin) return m;
    int number = 0;
    const Feature feature = a.towards(-up, number);
    ClippedPoints<kMostClipped> points(feature, up, height, margin);
    points.keepFour(up);
    for (int i = 0; i < points.count; ++i) {
        const Vec3 onA = points.position[i] - a.radius() * up;
        m.add(onA, onA - points.separation[i] * up,
              number * kMostClipped * kMostClipped + points.label[i]);
    }
    return m;
}

double apartFromTriangle(const Convex& triangle, const Convex& piece) {
    const Vec3 nearest = triangle.nearestTo(piece.centre()), out = piece.centre() - nearest;
    const double length = out.norm();
    if (!(length > 0.0)) return -kFar;
    return out.dot(piece.support(-out) - nearest) / length - piece.radius();
}

ConvexGap gapOf(const Convex& a, const Convex& b, double enough) {
    if (a.isTriangle() || b.isTriangle()) {  // its plane separates most pairs
        const Vec3 front = a.isTriangle() ? a.front() : Vec3(-b.front());
        const double above = separationOfCores(a, b, front) - a.radius() - b.radius();
        if (above > enough) return {above, front};
    }
    const WayOut out = wayOut(a, b, enough + a.radius() + b.radius());
    const bool behind = (a.isTriangle() && out.normal.dot(a.front()) < 0.0) ||
                        (b.isTriangle() && out.normal.dot(b.front()) > 0.0);
    if (behind) return {kFar, out.normal};
    return {out.separation - a.radius() - b.radius(), out.normal};
}

}  // namespace engine
