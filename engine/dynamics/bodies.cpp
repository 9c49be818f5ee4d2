#include "engine/dynamics/bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/check.h"
#include "engine/shapes/bounds.h"
#include "engine/shapes/mass.h"

namespace engine {
namespace {

constexpr double kSameMoment = 1e-12;  // of the moments about two axes, relative

/// The axis of a symmetric top (a capsule, a cylinder, a square bar), one of the body's; -1: there is none.
int topAxisOf(const Mat3& inertia) {
    if (!inertia.isDiagonal(0.0)) return -1;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = inertia((axis + 1) % 3, (axis + 1) % 3);
        const double b = inertia((axis + 2) % 3, (axis + 2) % 3);
        if (std::abs(a - b) <= kSameMoment * a) return axis;
    }
    return -1;
}

double thicknessOf(const Shape& shape) {
    if (shape.type == ShapeType::plane) return std::numeric_limits<double>::infinity();
    const Bounds bounds = boundsOf(shape, Pose{});
    return (bounds.high - bounds.low).minCoeff();
}

BodyMass massOf(const BodyDef& def) {
    if (def.kind != BodyKind::dynamic) return {};
    BodyMass m;
    m.mass = def.mass ? *def.mass : massOf(def.shape, def.material.density);
    ENGINE_CHECK(m.mass > 0.0 && std::isfinite(1.0 / m.mass) && std::isfinite(m.mass),
                 "a dynamic body needs a positive mass");
    m.inertia = def.inertia ? *def.inertia : inertiaOf(def.shape, m.mass);
    ENGINE_CHECK(!def.inertia || isInertia(m.inertia),
                 "an inertia tensor must be symmetric and positive definite, with no principal "
                 "moment larger than the sum of the others");
    const Eigen::LLT<Mat3> factor(m.inertia);
    ENGINE_CHECK(factor.info() == Eigen::Success, "a dynamic body needs a shape with an extent");
    m.inverseInertia = factor.solve(Mat3::Identity());
    m.isRound = m.inertia == m.inertia(0, 0) * Mat3::Identity();
    if (m.isRound) m.inverseInertia = Mat3::Identity() / m.inertia(0, 0);
    if (!m.isRound) m.topAxis = topAxisOf(m.inertia);
    return m;
}

void addSlot(Bodies& bodies) {
    bodies.defs.emplace_back();
    bodies.poses.emplace_back();
    bodies.velocities.emplace_back();
    bodies.inverseMasses.emplace_back();
    bodies.masses.emplace_back();
    bodies.thicknesses.emplace_back();
    bodies.massFactors.emplace_back(1.0);
    bodies.loads.emplace_back();
    bodies.accelerations.emplace_back();
    bodies.spans.emplace_back();
    bodies.strides.emplace_back();
    bodies.acts.emplace_back();
    bodies.present.emplace_back();
    bodies.asleep.emplace_back();
    bodies.placed.emplace_back();
}

}  // namespace

void addBody(Bodies& bodies, const BodyDef& def, int i) {
    const bool surface =
        def.shape.type == ShapeType::plane || def.shape.type == ShapeType::mesh;
    ENGINE_CHECK(def.kind != BodyKind::dynamic || !surface,
                 "a plane or a mesh has no mass; make it fixed or kinematic");
    ENGINE_CHECK(def.pose.rotation.norm() > 0.0, "a rotation needs a nonzero quaternion");
    BodyDef filled = def;
    filled.pose.rotation.normalize();
    const BodyMass mass = massOf(def);
    if (def.kind == BodyKind::dynamic) filled.mass = mass.mass, filled.inertia = mass.inertia;
    if (i == bodies.count()) addSlot(bodies);
    bodies.defs[i] = filled;
    bodies.poses[i] = filled.pose;
    const bool moves = def.kind != BodyKind::fixed;
    bodies.velocities[i] = moves ? Velocity{def.velocity, def.spin} : Velocity{};
    bodies.inverseMasses[i] = {mass.mass > 0.0 ? 1.0 / mass.mass : 0.0, Mat3::Zero()};
    bodies.masses[i] = mass;
    bodies.thicknesses[i] = thicknessOf(def.shape);
    bodies.massFactors[i] = 1.0;
    bodies.loads[i] = {};
    bodies.accelerations[i] = {};
    bodies.spans[i] = 0.0;
    bodies.strides[i] = bodies.acts[i] = 1;
    bodies.present[i] = 1;
    bodies.asleep[i] = -1;
    bodies.placed[i] = 1;
    bodies.hasSensors = bodies.hasSensors || def.sensor;
    activate(bodies, i);
    updateInverseInertia(bodies, i);
}

void activate(Bodies& bodies, int body) {
    ++bodies.activeChanges;
    const auto at = std::ranges::lower_bound(bodies.active, body);
    if (at != bodies.active.end() && *at == body) return;
    bodies.active.insert(at, body);
    bodies.restStale = bodies.restStale || bodies.isDynamic(body);
}

void leaveOutResting(Bodies& bodies) {
    if (!bodies.activeShrinks) return;
    std::erase_if(bodies.active, [&](int i) {
        return !bodies.present[i] || (!bodies.isMoving(i) && !bodies.placed[i]);
    });
    ++bodies.activeChanges;
    bodies.activeShrinks = false;
    bodies.restStale = true;
}

void setSpans(Bodies& bodies, double h) {
    bodies.spans.assign(bodies.count(), h);
    bodies.strides.assign(bodies.count(), 1);
    bodies.acts.assign(bodies.count(), 1);
}

void updateInverseInertia(Bodies& bodies, int i) {
    const BodyMass& mass = bodies.masses[i];
    InverseMass& inverse = bodies.inverseMasses[i];
    inverse.linear = mass.mass > 0.0 ? 1.0 / mass.mass : 0.0;
    inverse.angular = mass.isRound ? mass.inverseInertia
                                   : inWorldAxes(mass.inverseInertia, bodies.poses[i].rotation);
    if (bodies.massFactors[i] == 1.0) return;
    inverse.linear /= bodies.massFactors[i];
    inverse.angular /= bodies.massFactors[i];
}

void updateInverseInertias(Bodies& bodies) {
    for (const int i : bodies.active)
        if (bodies.isActing(i)) updateInverseInertia(bodies, i);
}

}  // namespace engine
