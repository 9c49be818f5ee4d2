// Mass and extent of the scenes' bodies.
#include <algorithm>
#include <cmath>

#include "tests/benchmark/peer_parts.h"

namespace peers {

namespace {

double ballVolume(double r) { return 4.0 / 3 * kPi * r * r * r; }
double coreVolume(const Body& capsule) {
    return 2 * kPi * capsule.radius * capsule.radius * capsule.halfSize.y();
}

/// A capsule's, along y and across it: of its core, a cylinder, and the halves of a ball at its ends.
Vec3 capsuleInertia(const Body& body) {
    const double r = body.radius, h = body.halfSize.y();
    const double core = body.density * coreVolume(body), ends = body.density * ballVolume(r);
    const double along = 0.5 * core * r * r + 0.4 * ends * r * r;
    const double across = core * (r * r / 4 + h * h / 3) +
                          ends * (0.4 * r * r + 0.75 * r * h + h * h);
    return {across, along, across};
}

}  // namespace

double Body::mass() const {
    if (kind == Kind::box) return density * 8 * halfSize.prod();
    return density * (ballVolume(radius) + (kind == Kind::capsule ? coreVolume(*this) : 0.0));
}

Vec3 Body::inertia() const {
    const double m = mass();
    if (kind == Kind::capsule) return capsuleInertia(*this);
    if (kind != Kind::box) return Vec3::Constant(0.4 * m * radius * radius);
    const Vec3 squares = halfSize.cwiseProduct(halfSize);
    return m / 3 * (Vec3::Constant(squares.sum()) - squares);
}

double Body::reach() const {
    if (kind == Kind::box) return halfSize.norm();
    if (kind == Kind::sphere) return radius;
    if (kind == Kind::capsule) return radius + halfSize.y();
    double most = 0.0;
    for (const Vec3& corner : corners) most = std::max(most, corner.norm());
    for (const Plate& plate : plates)
        most = std::max(most, plate.pose.position.norm() + plate.halfSize.norm());
    return most;
}

}  // namespace peers
