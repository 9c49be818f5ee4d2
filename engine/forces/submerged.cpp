#include "engine/forces/submerged.h"

#include "engine/base/trigonometry.h"
#include "engine/dynamics/mass.h"

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

/// Of a convex polygon: what lies below, in the same order.
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

/// Outwards of the axis k, anticlockwise seen from outside.
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

SubmergedPart ofBox(const Shape& box, const Pose& pose, const Vec3& up, double level) {
    const Vec3 apex = pose.position + (level - up.dot(pose.position)) * up;
    double sixfold = 0.0;
    Vec3 moment = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
        for (const double side : {1.0, -1.0}) {
            const Polygon part = faceOf(box, pose, k, side).below(up, level);
            for (int i = 2; i < part.count; ++i) {
                const Vec3 a = part.corner[0] - apex, b = part.corner[i - 1] - apex,
                           c = part.corner[i] - apex;
                const double v = a.dot(b.cross(c));
                sixfold += v;
                moment += v * (a + b + c);
            }
        }
    if (!(sixfold > 0.0)) return {};
    return {sixfold / 6.0, apex + moment / (4.0 * sixfold)};
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

double reachOf(const Shape& shape) {
    return shape.type == ShapeType::box ? shape.halfSize.norm() : shape.radius + shape.halfLength;
}

}  // namespace

SubmergedPart submergedPart(const Shape& shape, const Pose& pose, const Vec3& up, double level) {
    if (shape.type == ShapeType::plane) return {};
    const double under = level - up.dot(pose.position);
    if (under <= -reachOf(shape)) return {};
    if (under >= reachOf(shape)) return {volume(shape), pose.position};
    if (shape.type == ShapeType::box) return ofBox(shape, pose, up, level);
    if (shape.type == ShapeType::capsule) return ofCapsule(shape, pose, up, level);
    return ofBall(shape.radius, pose.position, up, level);
}

}  // namespace engine
