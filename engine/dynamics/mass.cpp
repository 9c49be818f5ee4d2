#include "engine/dynamics/mass.h"

#include "engine/base/trigonometry.h"

namespace engine {
namespace {

Mat3 sphereInertia(double radius, double mass) {
    return Mat3::Identity() * (0.4 * mass * radius * radius);
}

Mat3 boxInertia(const Vec3& half, double mass) {
    const Vec3 square = half.cwiseProduct(half);
    return Vec3(square.y() + square.z(), square.z() + square.x(), square.x() + square.y())
               .asDiagonal() * Mat3(Mat3::Identity() * (mass / 3.0));
}

Mat3 capsuleInertia(double r, double h, double mass) {
    // Shares of the mass by volume: cylinder 2 pi r^2 h, both half spheres 4/3 pi r^3.
    const double cylinder = mass * (2.0 * h) / (2.0 * h + 4.0 / 3.0 * r);
    const double balls = mass - cylinder;
    const double along = 0.5 * cylinder * r * r + 0.4 * balls * r * r;
    const double across = cylinder * (3.0 * r * r + 4.0 * h * h) / 12.0 +
                          balls * (0.4 * r * r + h * h + 0.75 * h * r);
    return Vec3(across, along, across).asDiagonal();
}

}  // namespace

double volume(const Shape& shape) {
    const double r = shape.radius;
    switch (shape.type) {
        case ShapeType::sphere: return 4.0 / 3.0 * kPi * r * r * r;
        case ShapeType::box: return 8.0 * shape.halfSize.prod();
        case ShapeType::capsule: return kPi * r * r * (2.0 * shape.halfLength + 4.0 / 3.0 * r);
        case ShapeType::plane: return 0.0;
    }
    return 0.0;
}

Mat3 inertiaOf(const Shape& shape, double mass) {
    switch (shape.type) {
        case ShapeType::sphere: return sphereInertia(shape.radius, mass);
        case ShapeType::box: return boxInertia(shape.halfSize, mass);
        case ShapeType::capsule: return capsuleInertia(shape.radius, shape.halfLength, mass);
        case ShapeType::plane: return Mat3::Zero();
    }
    return Mat3::Zero();
}

Mat3 inWorldAxes(const Mat3& inertiaBody, const Quat& rotation) {
    const Mat3 r = rotation.toRotationMatrix();
    const Mat3 half = r * inertiaBody;
    Mat3 world;
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {
            world(i, j) = half.row(i).dot(r.row(j));
            world(j, i) = world(i, j);
        }
    return world;
}

}  // namespace engine
