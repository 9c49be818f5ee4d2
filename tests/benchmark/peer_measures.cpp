#include "tests/benchmark/peer_measures.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace peers {

namespace {

/// rad, 0 to pi; also exact for small angles, where acos is not.
double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// A vector fixed in a body, rotated from the body's start to its present pose.
Vec3 carried(const Vec3& axis, const Pose& start, const Pose& now) {
    return now.rotation * Vec3(start.rotation.conjugate() * axis);
}

/// The points of a body that may be its lowest, about which it is round by the radius returned.
double lowPoints(const Body& body, std::vector<Vec3>& points) {
    points = body.corners;
    if (body.kind == Kind::sphere) points = {Vec3::Zero()};
    if (body.kind == Kind::capsule) points = {body.halfSize, -body.halfSize};
    for (int i = 0; body.kind == Kind::box && i < 8; ++i)
        points.push_back(body.halfSize.cwiseProduct(
            Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
    return body.kind == Kind::sphere || body.kind == Kind::capsule ? body.radius : 0.0;
}

/// sum of f(body, state) over the dynamic bodies
template <class Value, class F>
Value sumOverDynamic(const Scene& scene, States states, Value sum, F f) {
    for (std::size_t i = 0; i < states.size(); ++i)
        if (scene.bodies[i].dynamic) sum += f(scene.bodies[i], states[i]);
    return sum;
}

}  // namespace

Separation separation(const Scene& scene, States states) {
    Separation result;
    for (const Joint& joint : scene.joints) {
        const Pose &startA = scene.bodies[joint.a].pose, &startB = scene.bodies[joint.b].pose;
        const Pose &a = states[joint.a].pose, &b = states[joint.b].pose;
        const Vec3 gap = a.toWorld(startA.toLocal(joint.at)) - b.toWorld(startB.toLocal(joint.at));
        result.worst = std::max(result.worst, gap.norm());
        result.meanSquare += gap.squaredNorm() / static_cast<double>(scene.joints.size());
        if (!joint.isHinge) continue;
        const double angle =
            angleBetween(carried(joint.axis, startA, a), carried(joint.axis, startB, b));
        result.axisAngle = std::max(result.axisAngle, angle);
    }
    return result;
}

Drift drift(const Scene& scene, States states) {
    Drift result;
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (!scene.bodies[i].dynamic) continue;
        const Vec3 way = states[i].pose.position - scene.bodies[i].pose.position;
        result.total = std::max(result.total, way.norm());
        result.horizontal = std::max(result.horizontal, std::hypot(way.x(), way.z()));
        result.vertical = std::max(result.vertical, std::abs(way.y()));
    }
    return result;
}

// E = 1/2 m v^2 + 1/2 w I w - m g x
double energy(const Scene& scene, States states) {
    return sumOverDynamic(scene, states, 0.0, [&](const Body& body, const BodyState& s) {
        const double m = body.mass();
        const Vec3 w = s.pose.rotation.conjugate() * s.spin;  // body axes
        return 0.5 * m * s.velocity.squaredNorm() + 0.5 * w.dot(body.inertia().cwiseProduct(w)) -
               m * scene.gravity.dot(s.pose.position);
    });
}

// L = R I R^T w
Vec3 angularMomentum(const Scene& scene, States states) {
    return sumOverDynamic(scene, states, Vec3(0, 0, 0), [&](const Body& body, const BodyState& s) {
        const Vec3 w = s.pose.rotation.conjugate() * s.spin;  // body axes
        return Vec3(s.pose.rotation * Vec3(body.inertia().cwiseProduct(w)));
    });
}

double fastest(const Scene& scene, States states) {
    double result = 0.0;
    for (std::size_t i = 0; i < states.size(); ++i)
        if (scene.bodies[i].dynamic) result = std::max(result, states[i].velocity.norm());
    return result;
}

int lostBodies(const Scene& scene, States states) {
    if (!scene.lostBelow) return 0;
    return sumOverDynamic(scene, states, 0, [&](const Body&, const BodyState& s) {
        return s.pose.position.y() < *scene.lostBelow ? 1 : 0;
    });
}

double sunk(const Scene& scene, States states) {
    double deepest = 0.0;
    std::vector<Vec3> points;
    for (std::size_t i = 0; scene.ground && i < states.size(); ++i) {
        if (!scene.bodies[i].dynamic) continue;
        const double radius = lowPoints(scene.bodies[i], points);
        for (const Vec3& point : points) {
            const Vec3 at = states[i].pose.toWorld(point);
            deepest = std::max(deepest, scene.ground(at.x(), at.z()) - (at.y() - radius));
        }
    }
    return deepest;
}

bool finite(States states) {
    return std::all_of(states.begin(), states.end(), [](const BodyState& s) {
        return s.pose.position.allFinite() && s.pose.rotation.coeffs().allFinite() &&
               s.velocity.allFinite() && s.spin.allFinite();
    });
}

std::uint64_t hash(States states) {
    std::uint64_t hash = 1469598103934665603ull;
    const auto mix = [&](double number) {
        const auto bits = std::bit_cast<std::uint64_t>(number);
        for (int byte = 0; byte < 8; ++byte) {
            hash ^= (bits >> (8 * byte)) & 0xff;
            hash *= 1099511628211ull;
        }
    };
    for (const BodyState& s : states) {
        for (double x : s.pose.position) mix(x);
        for (double x : s.pose.rotation.coeffs()) mix(x);  // x y z w
    }
    return hash;
}

}  // namespace peers
