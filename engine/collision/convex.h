/// A convex piece of a body as the general collision functions see it, in world axes: by its
/// support mapping, its flat faces and the features that may lie on another's face. A ball is a
/// point and a capsule a segment, both with a radius around them.
#pragma once
#include "engine/collision/clip.h"
#include "engine/collision/pieces.h"
#include "engine/collision/segment.h"
#include "engine/shapes/hull.h"

namespace engine {

/// As a margin it leaves no point out; as a time it is never.
constexpr double kFar = 1e9;  // m, s

using Feature = PolygonOf<kMostClipped>;  // one corner, two, or a face's, counter-clockwise

/// normal . x = offset.
struct Plane {
    Vec3 normal;    // unit
    double offset;  // m
};

class Convex {
public:
    /// Anything but a plane, a compound or a mesh.
    Convex(const Shape& shape, const Pose& pose);
    /// A mesh's triangle.
    Convex(const Mesh& mesh, int triangle, const Pose& pose);

    double radius() const { return radius_; }
    const Vec3& centre() const { return centre_; }
    /// m: how far it reaches from its centre, without the radius.
    double reach() const { return reach_; }
    bool isTriangle() const { return mesh_ != nullptr; }
    /// It holds from this side only.
    const Vec3& front() const { return front_; }

    /// The point of the core farthest along n (any length).
    Vec3 support(const Vec3& n) const;

    int faceCount() const;
    Vec3 faceNormal(int face) const;
    /// Of a face, in the piece's own axes.
    Plane plane(int face) const;
    Vec3 toLocal(const Vec3& p) const { return turn_.transpose() * (p - pose_.position); }
    Vec3 turned(const Vec3& local) const { return turn_ * local; }  // a direction, to world axes
    Vec3 localOf(const Vec3& n) const { return turn_.transpose() * n; }  // and back
    Feature face(int face) const;

    /// What may touch a flat face that lies against it, n pointing towards that face: the face that
    /// looks at it the most, a line on a curved side, or a point. `number` of it, for names.
    Feature towards(const Vec3& n, int& number) const;
    /// The straight line on a curved side that n stands on; false: none, or n is more than three
    /// degrees off.
    bool line(const Vec3& n, Segment& result) const;
    /// Of a triangle, whose point p (on it) is: an edge that is not sharp, or a corner of such edges.
    bool isSmoothAt(const Vec3& p) const;
    /// Of a triangle: none of its edges is sharp.
    bool isSmooth() const;

private:
    Vec3 supportLocal(const Vec3& d) const;
    Feature disc(double y, const Vec3& n) const;
    Feature sideLine(const Vec3& local) const;
    void toWorld(Feature& feature) const;

    const Shape* shape_ = nullptr;
    const Mesh* mesh_ = nullptr;
    const Mesh::Triangle* triangle_ = nullptr;
    Pose pose_;
    Mat3 turn_;  // to world axes
    Vec3 centre_, front_ = Vec3::Zero();
    double radius_ = 0.0, reach_ = 0.0;
};

/// Of anything but a plane.
Convex convexOf(const Piece& piece, const Pose& body);

}  // namespace engine
