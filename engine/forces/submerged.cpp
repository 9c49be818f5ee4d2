#include "engine/forces/submerged.h"

#include "engine/base/trigonometry.h"
#include "engine/shapes/mass.h"
#include "engine/shapes/triangles.h"

namespace engine {
namespace {

constexpr int kBallsOfACapsule = 9;

SubmergedPart ofBall(double r, const Vec3& centre, const Vec3& up, double level) {
    const double depth = clamped(level - up.dot(centre) + r, 0.0, 2.0 * r);
    if (depth == 0.0) return {};
    const double rest = 2.0 * r - depth;
    const double down = 3.0 * rest * rest / (4.0 * (3.0 * r - depth));
    return {kPi * depth * depth * (3.0 * r - depth) / 3.0, centre - down * up};
}

/// A convex polygon; below() returns its part under the level, in the same order.
struct Polygon {
    Vec3 corner[5];
    int count = 0;

    Polygon below(const Vec3& up, double level) const {
        Polygon kept;
        for (int i = 0; i < count; ++i) {
            const Vec3 &p = corner[i], &q = corner[(i + 1) % count];
            const double hp = up.dot(p) - level, hq = up.dot(q) - level;
            if (hp <= 0.0) kept.corner[kept.count++] = p;
            if ((hp <= 0.0) != (hq <= 0.0) && kept.count < 5)
                kept.corner[kept.count++] = p + hp / (hp - hq) * (q - p);
        }
        return kept;
    }
};

/// The face at `side` of the axis k, counter-clockwise from outside.
Polygon faceOf(const Shape& box, const Pose& pose, int k, double side) {
    constexpr double kTurn[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    Polygon face;
    for (const auto& turn : kTurn) {
        Vec3 local;
        local[k] = side * box.halfSize[k];
        local[(k + 1) % 3] = side * turn[0] * box.halfSize[(k + 1) % 3];
        local[(k + 2) % 3] = turn[1] * box.halfSize[(k + 2) % 3];
        face.corner[face.count++] = pose.toWorld(local);
    }
    return face;
}

/// The sum of tetrahedra between a point of the water's surface and the submerged parts of faces.
class Tetrahedra {
public:
    Tetrahedra(const Vec3& apex, const Vec3& up, double level)
        : apex_(apex), up_(up), level_(level) {}

    void add(const Polygon& face) {
        const Polygon part = face.below(up_, level_);
        for (int i = 2; i < part.count; ++i) {
            const Vec3 a = part.corner[0] - apex_, b = part.corner[i - 1] - apex_,
                       c = part.corner[i] - apex_;
            const double v = a.dot(b.cross(c));
            sixfold_ += v;
            moment_ += v * (a + b + c);
        }
    }
    SubmergedPart sum() const {
        if (!(sixfold_ > 0.0)) return {};
        return {sixfold_ / 6.0, apex_ + moment_ / (4.0 * sixfold_)};
    }

private:
    Vec3 apex_, up_;
    double level_, sixfold_ = 0.0;
    Vec3 moment_ = Vec3::Zero();
};

Tetrahedra tetrahedra(const Pose& pose, const Vec3& up, double level) {
    return {pose.position + (level - up.dot(pose.position)) * up, up, level};
}

SubmergedPart ofBox(const Shape& box, const Pose& pose, const Vec3& up, double level) {
    Tetrahedra parts = tetrahedra(pose, up, level);
    for (int k = 0; k < 3; ++k)
        for (const double side : {1.0, -1.0}) parts.add(faceOf(box, pose, k, side));
    return parts.sum();
}

/// The volume is scaled, because the triangles enclose less than the shape.
SubmergedPart ofSurface(const Shape& shape, const Pose& pose, const Vec3& up, double level) {
    Tetrahedra parts = tetrahedra(pose, up, level);
    double all = 0.0;
    forTriangles(shape, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        all += a.dot(b.cross(c)) / 6.0;
        Polygon face;
        for (const Vec3* p : {&a, &b, &c}) face.corner[face.count++] = pose.toWorld(*p);
        parts.add(face);
    });
    SubmergedPart part = parts.sum();
    part.volume *= volume(shape) / all;
    return part;
}

SubmergedPart ofCompound(const ShapeParts& parts, const Pose& pose, const Vec3& up, double level) {
    SubmergedPart all;
    Vec3 moment = Vec3::Zero();
    for (const ShapePart& part : parts) {
        const Pose at{pose.toWorld(part.pose.position), pose.rotation * part.pose.rotation};
        const SubmergedPart own = submergedPart(part.shape, at, up, level);
        all.volume += own.volume;
        moment += own.volume * own.centre;
    }
    if (all.volume > 0.0) all.centre = moment / all.volume;
    return all;
}

SubmergedPart ofCapsule(const Shape& capsule, const Pose& pose, const Vec3& up, double level) {
    const double ball = volume(Shape::sphere(capsule.radius));
    const double share = volume(capsule) / (kBallsOfACapsule * ball);
    SubmergedPart all;
    Vec3 moment = Vec3::Zero();
    for (int i = 0; i < kBallsOfACapsule; ++i) {
        const double along = 2.0 * i / (kBallsOfACapsule - 1) - 1.0;
        const Vec3 centre = pose.toWorld({0.0, along * capsule.halfLength, 0.0});
        const SubmergedPart part = ofBall(capsule.radius, centre, up, level);
        all.volume += share * part.volume;
        moment += share * part.volume * part.centre;
    }
    if (all.volume > 0.0) all.centre = moment / all.volume;
    return all;
}

}  // namespace

SubmergedPart submergedPart(const Shape& shape, const Pose& pose, const Vec3& up, double level) {
    if (shape.type == ShapeType::plane || shape.type == ShapeType::mesh) return {};
    const double under = level - up.dot(pose.position);
    if (under <= -reachOf(shape)) return {};
    if (under >= reachOf(shape)) return {volume(shape), pose.position};
    switch (shape.type) {
        case ShapeType::box: return ofBox(shape, pose, up, level);
        case ShapeType::capsule: return ofCapsule(shape, pose, up, level);
        case ShapeType::sphere: return ofBall(shape.radius, pose.position, up, level);
        case ShapeType::compound: return ofCompound(*shape.parts, pose, up, level);
        default: return ofSurface(shape, pose, up, level);
    }
}

}  // namespace engine
