#include "engine/shapes/mass.h"

#include "engine/base/trigonometry.h"
#include "engine/shapes/hull.h"

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

Mat3 cylinderInertia(double r, double h, double mass) {
    const double across = mass * (3.0 * r * r + 4.0 * h * h) / 12.0;
    return Vec3(across, 0.5 * mass * r * r, across).asDiagonal();
}

Mat3 coneInertia(double r, double h, double mass) {
    const double across = 0.15 * mass * (r * r + h * h);  // h is half the height
    return Vec3(across, 0.3 * mass * r * r, across).asDiagonal();
}

Mat3 fromSecond(const Mat3& second) {
    return second.trace() * Mat3::Identity() - second;
}

double volumeOf(const ShapeParts& parts) {
    double sum = 0.0;
    for (const ShapePart& part : parts) sum += volume(part.shape);
    return sum;
}

VolumeIntegrals integralsOf(const Shape& shape) {
    if (shape.type == ShapeType::hull) return integralsOf(*shape.hull);
    if (shape.type == ShapeType::compound) return integralsOf(*shape.parts);
    VolumeIntegrals sum;
    sum.volume = volume(shape);
    const Mat3 inertia = inertiaOf(shape, sum.volume);
    sum.second = 0.5 * inertia.trace() * Mat3::Identity() - inertia;
    return sum;
}

}  // namespace

VolumeIntegrals integralsOf(const Hull& hull) {
    VolumeIntegrals sum;
    for (const Hull::Face& face : hull.faces)
        for (std::size_t i = 2; i < face.corners.size(); ++i) {
            const Vec3 a = hull.corners[face.corners[0]], b = hull.corners[face.corners[i - 1]],
                       c = hull.corners[face.corners[i]], all = a + b + c;
            const double v = a.dot(b.cross(c)) / 6.0;
            sum.volume += v;
            sum.first += 0.25 * v * all;
            sum.second += v / 20.0 * (a * a.transpose() + b * b.transpose() + c * c.transpose() +
                                      all * all.transpose());
        }
    return sum;
}

VolumeIntegrals integralsOf(std::span<const ShapePart> parts) {
    VolumeIntegrals sum;
    for (const ShapePart& part : parts) {
        const VolumeIntegrals own = integralsOf(part.shape);
        const Vec3 p = part.pose.position;
        const double weight = part.density * own.volume;
        sum.volume += weight;
        sum.first += weight * p;
        sum.second += part.density * inWorldAxes(own.second, part.pose.rotation) +
                      weight * p * p.transpose();
    }
    return sum;
}

double volume(const Shape& shape) {
    const double r = shape.radius;
    switch (shape.type) {
        case ShapeType::sphere: return 4.0 / 3.0 * kPi * r * r * r;
        case ShapeType::box: return 8.0 * shape.halfSize.prod();
        case ShapeType::capsule: return kPi * r * r * (2.0 * shape.halfLength + 4.0 / 3.0 * r);
        case ShapeType::cylinder: return kPi * r * r * 2.0 * shape.halfLength;
        case ShapeType::cone: return kPi * r * r * 2.0 * shape.halfLength / 3.0;
        case ShapeType::hull: return integralsOf(*shape.hull).volume;
        case ShapeType::compound: return volumeOf(*shape.parts);
        case ShapeType::plane:
        case ShapeType::mesh: return 0.0;
    }
    return 0.0;
}

double massOf(const Shape& shape, double density) {
    const bool mixed = shape.type == ShapeType::compound;
    return density * (mixed ? integralsOf(*shape.parts).volume : volume(shape));
}

Mat3 inertiaOf(const Shape& shape, double mass) {
    switch (shape.type) {
        case ShapeType::sphere: return sphereInertia(shape.radius, mass);
        case ShapeType::box: return boxInertia(shape.halfSize, mass);
        case ShapeType::capsule: return capsuleInertia(shape.radius, shape.halfLength, mass);
        case ShapeType::cylinder: return cylinderInertia(shape.radius, shape.halfLength, mass);
        case ShapeType::cone: return coneInertia(shape.radius, shape.halfLength, mass);
        case ShapeType::hull:
        case ShapeType::compound: {
            const VolumeIntegrals sum = integralsOf(shape);
            return mass / sum.volume * fromSecond(sum.second);
        }
        case ShapeType::plane:
        case ShapeType::mesh: return Mat3::Zero();
    }
    return Mat3::Zero();
}

bool isInertia(const Mat3& inertia) {
    constexpr double kRounding = 1e-6;  // of the trace; S of a thin plate has a zero eigenvalue
    const double trace = inertia.trace();
    const Mat3 second = (0.5 + kRounding) * trace * Mat3::Identity() - inertia;
    return inertia.isApprox(inertia.transpose()) &&
           Eigen::LLT<Mat3>(inertia).info() == Eigen::Success &&
           Eigen::LLT<Mat3>(second).info() == Eigen::Success;
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
