/// A convex piece of a body for the general collision functions, in world axes: its support mapping, its flat
/// faces and the features that may lie on another piece's face. A ball is a point and a capsule a segment,
/// both with a radius around them.
#pragma once
#include "engine/collision/clip.h"
#include "engine/collision/pieces.h"
#include "engine/collision/segment.h"
#include "engine/shapes/hull.h"

namespace engine {

/// Infinity: as a margin it includes every point; as a time it means never.
constexpr double kFar = 1e9;  // m, s

using Feature = PolygonOf<kMostClipped>;  // a point, a line, or a face, counter-clockwise

/// normal . x = offset.
struct Plane {
    Vec3 normal;    // unit
    double offset;  // m
};

class Convex {
public:
    /// For every shape except planes, compounds and meshes.
    Convex(const Shape& shape, const Pose& pose);
    /// A triangle of a mesh.
    Convex(const Mesh& mesh, int triangle, const Pose& pose);

    double radius() const { return radius_; }
    const Vec3& centre() const { return centre_; }
    /// m: the largest distance from its centre, without the radius.
    double reach() const { return reach_; }
    bool isTriangle() const { return mesh_ != nullptr; }
    /// A triangle's normal; it is solid from this side only.
    const Vec3& front() const { return front_; }

    /// For a triangle: its point nearest to p.
    Vec3 nearestTo(const Vec3& p) const;
    /// The point of the core farthest along n (of any length).
    Vec3 support(const Vec3& n) const {
        const Vec3 d = turn_.transpose() * n;
        if (triangle_) return corners_[farthestOfTriangle(d)];
        return pose_.position + turn_ * supportLocal(d);
    }

    int faceCount() const {
        if (triangle_) return 1;
        return shape_->type == ShapeType::hull ? static_cast<int>(shape_->hull->faces.size())
                                               : faceCountOf(shape_->type);
    }
    Vec3 faceNormal(int face) const;
    /// The plane of a face, in the piece's own axes.
    Plane plane(int face) const {
        if (!triangle_ && shape_->type == ShapeType::hull) {
            const Hull::Face& own = shape_->hull->faces[face];
            return {own.normal, own.offset};
        }
        return flatPlane(face);
    }
    /// See FaceLanes; p in the piece's own axes (m), and up to kMostFaces bounds.
    int lowerBounds(const Vec3& p, double radii, double* bounds) const;
    static constexpr int kMostFaces = 2 * Shape::kMostCorners;
    Vec3 toLocal(const Vec3& p) const { return turn_.transpose() * (p - pose_.position); }
    Vec3 turned(const Vec3& local) const { return turn_ * local; }  // a direction, to world axes
    Vec3 localOf(const Vec3& n) const { return turn_.transpose() * n; }  // and back
    Feature face(int face) const;

    /// The feature that may touch another piece's flat face, n pointing towards that face: the face most
    /// aligned with n, a line on a curved side, or a point. `number` identifies it, for feature names.
    Feature towards(const Vec3& n, int& number) const;
    /// The straight line on a curved side whose normal is n; false: none, or n is more than three degrees
    /// off.
    bool line(const Vec3& n, Segment& result) const;
    /// For a triangle: whether its point p is on an edge that is not sharp, or on a corner of such edges.
    bool isSmoothAt(const Vec3& p) const;
    /// For a triangle: whether none of its edges is sharp.
    bool isSmooth() const;
    /// For a triangle: whether one of its edges is convex, but not sharp.
    bool isAnySlight() const { return triangle_->isAnySlight(); }
    /// For a triangle: whether its point p is on such an edge, and no triangle beside it rises above the
    /// plane through p with the normal n. There only this edge may touch a piece above it.
    bool isTopAt(const Vec3& p, const Vec3& n) const;

private:
    /// m: nearer points of a triangle are on its edge.
    double onEdge() const { return 1e-6 * (1.0 + reach_); }
    /// Whether p, in its own axes, is on edge i.
    bool isOnEdge(int i, const Vec3& p) const;
    int farthestOfTriangle(const Vec3& d) const {
        const auto along = [&](int i) { return d.dot(mesh_->corners[triangle_->corners[i]]); };
        const double first = along(0), second = along(1);
        return along(2) > larger(first, second) ? 2 : second > first ? 1 : 0;
    }
    /// Of a shape, in its own axes.
    Vec3 supportLocal(const Vec3& d) const {
        const Shape& s = *shape_;
        switch (s.type) {
            case ShapeType::capsule: return {0.0, d.y() < 0.0 ? -s.halfLength : s.halfLength, 0.0};
            case ShapeType::box:
                return {d.x() < 0.0 ? -s.halfSize.x() : s.halfSize.x(),
                        d.y() < 0.0 ? -s.halfSize.y() : s.halfSize.y(),
                        d.z() < 0.0 ? -s.halfSize.z() : s.halfSize.z()};
            case ShapeType::hull: return s.hull->corners[s.hull->cornerLanes.farthest(d)];
            case ShapeType::sphere: return Vec3::Zero();
            default: return supportOfRound(d);
        }
    }
    /// Of a cylinder or a cone.
    Vec3 supportOfRound(const Vec3& d) const;
    static int faceCountOf(ShapeType type);
    /// The plane of a face of any piece but a hull.
    Plane flatPlane(int face) const;
    Feature disc(double y, const Vec3& n) const;
    Feature sideLine(const Vec3& local) const;
    void toWorld(Feature& feature) const;

    const Shape* shape_ = nullptr;
    const Mesh* mesh_ = nullptr;
    const Mesh::Triangle* triangle_ = nullptr;
    Pose pose_;
    Mat3 turn_;  // to world axes
    Vec3 centre_, front_ = Vec3::Zero();
    std::array<Vec3, 3> corners_;  // m, of a triangle, in world axes
    double radius_ = 0.0, reach_ = 0.0;
};

/// For every piece except planes.
Convex convexOf(const Piece& piece, const Pose& body);

}  // namespace engine
