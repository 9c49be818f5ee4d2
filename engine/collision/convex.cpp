#include "engine/collision/convex.h"

#include "engine/base/trigonometry.h"

namespace engine {
namespace {

constexpr int kRim = 16;             // corners of the polygon that represents a circle
constexpr double kAlong = 0.05;      // sine: a line within three degrees
constexpr double kTilted = 1e-3;     // sine: a disc tilted less keeps its corners
constexpr int kCorners = kMostClipped / 2;  // of a face, at most: the rest is for clipping

/// The unit circle's corners.
const std::array<Vec2, kRim>& rim() {
    static const std::array<Vec2, kRim> corners = [] {
        std::array<Vec2, kRim> c;
        for (int i = 0; i < kRim; ++i)
            c[i] = {cosine(2.0 * kPi * i / kRim), sine(2.0 * kPi * i / kRim)};
        return c;
    }();
    return corners;
}

bool isRound(ShapeType type) { return type == ShapeType::cylinder || type == ShapeType::cone; }

/// The base's and the top's height; a cone's top is its tip.
double baseOf(const Shape& s) {
    return s.type == ShapeType::cone ? -0.5 * s.halfLength : -s.halfLength;
}
double topOf(const Shape& s) {
    return s.type == ShapeType::cone ? 1.5 * s.halfLength : s.halfLength;
}

/// The unit vector of d's part across y, or x where that is zero.
Vec3 outwards(const Vec3& d) {
    const Vec3 across(d.x(), 0.0, d.z());
    const double length = across.norm();
    return length > 0.0 ? Vec3(across / length) : Vec3(Vec3::UnitX());
}

}  // namespace

Convex::Convex(const Shape& shape, const Pose& pose)
    : shape_(&shape), pose_(pose), turn_(pose.rotation.toRotationMatrix()) {
    centre_ = pose.position;
    const bool ball = shape.type == ShapeType::sphere, pill = shape.type == ShapeType::capsule;
    if (ball || pill) radius_ = shape.radius;
    reach_ = ball ? 0.0 : pill ? shape.halfLength : reachOf(shape);
}

Convex::Convex(const Mesh& mesh, int triangle, const Pose& pose)
    : mesh_(&mesh), triangle_(&mesh.triangles[triangle]), pose_(pose),
      turn_(pose.rotation.toRotationMatrix()) {
    for (int i = 0; i < 3; ++i)
        corners_[i] = pose.position + turn_ * mesh.corners[triangle_->corners[i]];
    reach_ = triangle_->reach;
    centre_ = pose.position + turn_ * triangle_->middle;
    front_ = turn_ * triangle_->normal;
}

Convex convexOf(const Piece& piece, const Pose& body) {
    if (piece.isTriangle) return {*piece.shape->mesh, piece.number, body};
    return {*piece.shape, piece.at(body)};
}

/// By the Voronoi regions of corners and edges (Ericson 2005, 5.1.5).
Vec3 Convex::nearestTo(const Vec3& p) const {
    const auto& [a, b, c] = corners_;
    const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp),
                 d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    if (d3 >= 0.0 && d4 <= d3) return b;
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6)
        return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    const double all = va + vb + vc;
    return a + vb / all * ab + vc / all * ac;
}

Vec3 Convex::supportOfRound(const Vec3& d) const {
    const Shape& s = *shape_;
    Vec3 p = s.radius * outwards(d);
    if (s.type == ShapeType::cylinder) {
        p.y() = d.y() < 0.0 ? baseOf(s) : topOf(s);
        return p;
    }
    const Vec3 tip(0.0, topOf(s), 0.0);
    p.y() = baseOf(s);
    return d.dot(p) > d.dot(tip) ? p : tip;
}

int Convex::faceCountOf(ShapeType type) {
    switch (type) {
        case ShapeType::box: return 6;
        case ShapeType::cylinder: return 2;
        case ShapeType::cone: return 1;
        default: return 0;
    }
}

Vec3 Convex::faceNormal(int face) const {
    if (triangle_) return front_;
    if (shape_->type == ShapeType::hull) return turn_ * shape_->hull->faces[face].normal;
    const int axis = shape_->type == ShapeType::box ? face / 2 : 1;
    return face % 2 == 0 ? Vec3(-turn_.col(axis)) : Vec3(turn_.col(axis));
}

Plane Convex::flatPlane(int face) const {
    if (triangle_)
        return {triangle_->normal, triangle_->normal.dot(mesh_->corners[triangle_->corners[0]])};
    const int axis = shape_->type == ShapeType::box ? face / 2 : 1;
    const Vec3 n = (face % 2 == 0 ? -1.0 : 1.0) * Vec3::Unit(axis);
    if (shape_->type == ShapeType::box) return {n, shape_->halfSize[axis]};
    return {n, face == 0 ? -baseOf(*shape_) : topOf(*shape_)};
}

int Convex::lowerBounds(const Vec3& p, double radii, double* bounds) const {
    if (!triangle_ && shape_->type == ShapeType::hull)
        return shape_->hull->faceLanes.lower(p, radii, bounds);
    int best = 0;
    for (int i = 0; i < faceCount(); ++i) {
        const Plane own = flatPlane(i);
        bounds[i] = smaller(bounds[i], own.normal.dot(p) - own.offset - radii);
        if (bounds[i] > bounds[best]) best = i;
    }
    return best;
}

Feature Convex::disc(double y, const Vec3& n) const {
    const Vec3 local = turn_.transpose() * n;
    const double tilt = std::sqrt(local.x() * local.x() + local.z() * local.z());
    // Whatever the tilt, the point that touches first is a corner of the polygon.
    const Vec3 first = tilt > kTilted * local.norm() ? outwards(local) : Vec3(Vec3::UnitX());
    const Vec3 second(first.z(), 0.0, -first.x());
    Feature feature;
    for (int i = 0; i < kRim; ++i) {
        const int k = y < 0.0 ? kRim - 1 - i : i;  // counter-clockwise from outside
        const Vec3 p = shape_->radius * (rim()[k].x() * first + rim()[k].y() * second);
        feature.add({p.x(), y, p.z()}, i);
    }
    toWorld(feature);
    return feature;
}

Feature Convex::face(int face) const {
    Feature feature;
    if (triangle_) {
        for (int i = 0; i < 3; ++i) feature.add(corners_[i], i);
        return feature;
    } else if (shape_->type == ShapeType::hull) {
        const std::vector<int>& corners = shape_->hull->faces[face].corners;
        const int count = static_cast<int>(corners.size());
        const int kept = count < kCorners ? count : kCorners;
        for (int i = 0; i < kept; ++i)
            feature.add(shape_->hull->corners[corners[i * count / kept]], i);
    } else if (shape_->type == ShapeType::box) {
        const double side = face % 2 == 0 ? -1.0 : 1.0;
        const Polygon box = faceOf(Mat3::Identity(), Vec3::Zero(), shape_->halfSize, face / 2, side);
        for (int i = 0; i < 4; ++i) feature.add(box.corner[side < 0.0 ? 3 - i : i], i);
    } else {
        return disc(face == 0 ? baseOf(*shape_) : topOf(*shape_), faceNormal(face));
    }
    toWorld(feature);
    return feature;
}

void Convex::toWorld(Feature& feature) const {
    for (int i = 0; i < feature.count; ++i)
        feature.corner[i] = pose_.position + turn_ * feature.corner[i];
}

/// The line from the base's rim to that of the top, on the side of `local`.
Feature Convex::sideLine(const Vec3& local) const {
    const Vec3 out = shape_->radius * outwards(local);
    Feature feature;
    feature.add({out.x(), baseOf(*shape_), out.z()}, 0);
    if (shape_->type == ShapeType::cone)
        feature.add({0.0, topOf(*shape_), 0.0}, 1);
    else
        feature.add({out.x(), topOf(*shape_), out.z()}, 1);
    toWorld(feature);
    return feature;
}

Feature Convex::towards(const Vec3& n, int& number) const {
    number = 0;
    Feature feature;
    if (triangle_) return face(0);
    const Vec3 local = turn_.transpose() * n;
    if (shape_->type == ShapeType::sphere) {
        feature.add(pose_.position, 0);
    } else if (shape_->type == ShapeType::capsule) {
        feature.add({0.0, -shape_->halfLength, 0.0}, 0);
        feature.add({0.0, shape_->halfLength, 0.0}, 1);
        toWorld(feature);
    } else if (isRound(shape_->type)) {
        const bool cone = shape_->type == ShapeType::cone;
        const bool end = cone ? local.y() < -0.7 : std::abs(local.y()) > 0.7;
        number = end ? (local.y() < 0.0 ? 0 : 1) : 2;
        if (!end) return sideLine(local);
        return disc(local.y() < 0.0 ? baseOf(*shape_) : topOf(*shape_), n);
    } else {
        double most = -2.0;
        for (int i = 0; i < faceCount(); ++i)
            if (const double along = plane(i).normal.dot(local); along > most + 1e-3)
                most = along, number = i;
        return face(number);
    }
    return feature;
}

bool Convex::line(const Vec3& n, Segment& result) const {
    if (triangle_) return false;
    const Vec3 local = turn_.transpose() * n;
    if (shape_->type == ShapeType::capsule) {
        if (std::abs(local.y()) > kAlong) return false;
        result = coreOf(*shape_, pose_);
        return shape_->halfLength > 0.0;
    }
    if (!isRound(shape_->type)) return false;
    // Direction of the side line: y for a cylinder, inclined by the slope for a cone.
    const double height = topOf(*shape_) - baseOf(*shape_);
    const double inwards = shape_->type == ShapeType::cone ? shape_->radius : 0.0;
    const Vec3 out = outwards(local);
    const Vec3 along = Vec3(-inwards * out.x(), height, -inwards * out.z()).normalized();
    if (std::abs(along.dot(local)) > kAlong) return false;
    const Feature ends = sideLine(local);
    result = {0.5 * (ends.corner[0] + ends.corner[1]), 0.5 * (ends.corner[1] - ends.corner[0])};
    return true;
}

bool Convex::isSmooth() const {
    const std::array<bool, 3>& sharp = triangle_->sharp;
    return !sharp[0] && !sharp[1] && !sharp[2];
}

bool Convex::isOnEdge(int i, const Vec3& p) const {
    const Vec3& from = mesh_->corners[triangle_->corners[i]];
    const Vec3 edge = mesh_->corners[triangle_->corners[(i + 1) % 3]] - from;
    return edge.cross(p - from).norm() / edge.norm() <= onEdge();
}

bool Convex::isSmoothAt(const Vec3& world) const {
    const Vec3 p = pose_.toLocal(world);
    bool onSmooth = false;
    for (int i = 0; i < 3; ++i) {
        if (!isOnEdge(i, p)) continue;
        if (triangle_->sharp[i]) return false;
        onSmooth = true;
    }
    return onSmooth;
}

bool Convex::isTopAt(const Vec3& world, const Vec3& normal) const {
    const Vec3 p = pose_.toLocal(world), n = localOf(normal);
    const auto rises = [&](int corner, int alsoBeside) {
        return std::ranges::any_of(mesh_->besideOf(corner), [&](const auto& pair) {
            const std::pair edge(pair.second, alsoBeside);
            const bool counts = alsoBeside < 0 || std::ranges::binary_search(mesh_->beside, edge);
            return counts && n.dot(mesh_->corners[pair.second] - p) > onEdge();
        });
    };
    for (int i = 0; i < 3; ++i) {
        if (!triangle_->slight[i] || !isOnEdge(i, p)) continue;
        const int from = triangle_->corners[i], to = triangle_->corners[(i + 1) % 3];
        for (const int end : {from, to})
            if ((p - mesh_->corners[end]).norm() <= onEdge()) return !rises(end, -1);
        return !rises(from, to);
    }
    return false;
}

}  // namespace engine
