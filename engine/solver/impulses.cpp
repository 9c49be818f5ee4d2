#include "engine/solver/impulses.h"

#include "engine/constraints/rolling.h"
#include "engine/solver/block_factors.h"
#include "engine/solver/drives.h"
#include "engine/solver/exact_velocities.h"
#include "engine/solver/impacts.h"

namespace engine {
namespace {

template <class Real>
Real biasOf(const ContactRow<Real>& row, Real restitution, Real approach, const Settings& settings,
            Real h) {
    const Real slop = static_cast<Real>(settings.slop);
    const bool touches = row.separation + h * approach <= Real(0);
    if (settings.bounce == Bounce::bias && restitution > Real(0) && touches &&
        approach < -static_cast<Real>(settings.bounceSpeed))
        return restitution * approach;
    if (row.separation > Real(0)) return row.separation / h;
    if (row.separation < -slop)
        return static_cast<Real>(settings.baumgarte) * (row.separation + slop) / h;
    return Real(0);
}

/// (J M^-1 J^T)^-1 of all rows.
template <class Real>
Eigen::Matrix<Real, 6, 6> massOf(const JointConstraint<Real>& joint) {
    Eigen::Matrix<double, 6, 6> k = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> scale = Eigen::Matrix<double, 6, 1>::Zero();
    for (int i = 0; i < joint.count; ++i) {
        for (int l = 0; l < joint.count; ++l)
            k(i, l) = static_cast<double>(coupling(joint.rows[i], joint.rows[l]));
        k(i, i) += static_cast<double>(joint.softness[i]);
        scale[i] = k(i, i);
    }
    sweepPivots<6>(k, scale);
    return k.cast<Real>();
}

/// b, softness, and the block of the point's rows; after the rows were made.
template <class Real>
void setBiases(JointConstraint<Real>& joint, const Settings& settings, Real h) {
    for (int i = 0; i < joint.count; ++i) {
        const SoftRow<Real> soft =
            joint.spring.isSoft() ? softRow(joint.spring, joint.rows[i].k, joint.error[i], h)
                                  : SoftRow<Real>{Real(0), static_cast<Real>(settings.baumgarte) *
                                                               joint.error[i] / h};
        joint.softness[i] = soft.softness;
        joint.bias[i] = soft.bias;
    }
    joint.allAtOnce = settings.block && !joint.inTree && joint.asBlock;
    if (joint.allAtOnce) joint.mass = massOf(joint);
    joint.pointAtOnce = settings.block && !joint.inTree && !joint.asBlock && joint.count >= 3;
    if (!joint.pointAtOnce) return;
    Mat3T<Real> k;
    for (int i = 0; i < 3; ++i)
        for (int l = 0; l < 3; ++l) k(i, l) = coupling(joint.rows[i], joint.rows[l]);
    for (int i = 0; i < 3; ++i) k(i, i) += joint.softness[i];
    joint.pointMass = k.inverse();
}

/// The point's three rows as one: lambda = -K^-1 (J v + b).
template <class Real>
void sweepPoint(JointConstraint<Real>& joint, Velocity<Real>& a, Velocity<Real>& b,
                Correction<Real>& correction) {
    Vec3T<Real> left;
    for (int i = 0; i < 3; ++i)
        left[i] = velocityAlong(joint.rows[i].j, a, b) + joint.bias[i] +
                  joint.softness[i] * joint.lambda[i];
    const Vec3T<Real> lambda = -(joint.pointMass * left);
    for (int i = 0; i < 3; ++i) {
        joint.lambda[i] += lambda[i];
        push(joint, i, lambda[i], a, b);
        correction.add(left[i], lambda[i]);
    }
}

/// All rows as one.
template <class Real>
void sweepWhole(JointConstraint<Real>& joint, Velocity<Real>& a, Velocity<Real>& b,
                Correction<Real>& correction) {
    Eigen::Matrix<Real, 6, 1> left = Eigen::Matrix<Real, 6, 1>::Zero();
    for (int i = 0; i < joint.count; ++i)
        left[i] = velocityAlong(joint.rows[i].j, a, b) + joint.bias[i] +
                  joint.softness[i] * joint.lambda[i];
    const Eigen::Matrix<Real, 6, 1> lambda = -(joint.mass * left);
    for (int i = 0; i < joint.count; ++i) {
        joint.lambda[i] += lambda[i];
        push(joint, i, lambda[i], a, b);
        correction.add(left[i], lambda[i]);
    }
}

template <class Real>
void sweepJoint(JointConstraint<Real>& joint, Velocity<Real>& a, Velocity<Real>& b,
                Correction<Real>& correction) {
    if (joint.allAtOnce) return sweepWhole(joint, a, b, correction);
    if (joint.pointAtOnce) sweepPoint(joint, a, b, correction);
    for (int i = joint.pointAtOnce ? 3 : 0; i < joint.count; ++i) {
        const Row<Real>& row = joint.rows[i];
        const Real lambda =
            correctiveImpulse(row, joint.bias[i], joint.softness[i], joint.lambda[i], a, b);
        joint.lambda[i] += lambda;
        push(joint, i, lambda, a, b);
        correction.add((row.k + joint.softness[i]) * lambda, lambda);
    }
}

template <class Real>
void sweepContact(ContactConstraint<Real>& contact, std::span<Velocity<Real>> v,
                  const Settings& settings, Correction<Real>& correction) {
    Velocity<Real>&a = v[contact.a], &b = v[contact.b];
    if (settings.block && settings.accumulate)
        solveNormalsTogether(contact, a, b, correction);
    else
        solveNormals(contact, settings.accumulate, a, b, correction);
    solveFriction(contact, a, b, correction);
    solveRolling(contact, a, b, correction);
}

}  // namespace

template <class Real>
void setBiases(Constraints<Real>& c, std::span<const Velocity<Real>> v, const Settings& settings,
               Real h) {
    for (ContactConstraint<Real>& contact : c.contacts)
        for (int i = 0; i < contact.count; ++i) {
            ContactRow<Real>& row = contact.rows[i];
            const Real approach = contact.n.dot(velocityBetween(row, v[contact.a], v[contact.b]));
            row.bias = biasOf(row, contact.restitution, approach, settings, h);
            row.bounce = Real(0);
        }
    for (JointConstraint<Real>& joint : c.joints)
        if (!joint.inTree || settings.compareExact) setBiases(joint, settings, h);
    setDriveBiases(c, settings, h);
}

template <class Real>
void warmStart(Constraints<Real>& c, std::span<Velocity<Real>> v, const Settings& settings) {
    const Real keep = settings.warmStart && settings.accumulate ? Real(1) : Real(0);
    for (JointConstraint<Real>& joint : c.joints) {
        if (joint.inTree) continue;
        for (int i = 0; i < joint.count; ++i) {
            joint.lambda[i] *= keep;
            push(joint, i, joint.lambda[i], v[joint.a], v[joint.b]);
        }
    }
    warmStartDrives(c, keep, v);
    for (ContactConstraint<Real>& contact : c.contacts) {
        Velocity<Real>&a = v[contact.a], &b = v[contact.b];
        for (int i = 0; i < contact.count; ++i) {
            ContactRow<Real>& row = contact.rows[i];
            row.lambda *= keep;
            row.friction *= keep;
            applyAt<Real>(contact, row, impulseOf(contact, row), a, b);
        }
        if (contact.rolling <= Real(0)) continue;
        contact.rollingMoment *= keep;
        applyRolling<Real>(contact, contact.rollingMoment, a, b);
    }
}

template <class Real>
SweepReport sweep(Constraints<Real>& c, JointTrees& trees, std::span<Velocity<Real>> v,
                  const Settings& settings) {
    Correction<Real> correction;
    trees.solveVelocities(v, correction);
    for (JointConstraint<Real>& joint : c.joints)
        if (!joint.inTree) sweepJoint(joint, v[joint.a], v[joint.b], correction);
    sweepDrives(c, v, correction);
    for (const int i : c.order) sweepContact(c.contacts[i], v, settings, correction);
    return {static_cast<double>(correction.velocity), static_cast<double>(correction.impulse)};
}

template <class Real>
void beginSolving(Constraints<Real>& c, std::span<Velocity<Real>> v, const Settings& settings,
                  Real h) {
    setBiases<Real>(c, v, settings, h);
    if (settings.bounce == Bounce::impacts) solveImpacts(c, v, settings, h);
}

template <class Real>
void bookImpulses(Constraints<Real>& c) {
    for (ContactConstraint<Real>& contact : c.contacts)
        for (int i = 0; i < contact.count; ++i) {
            ContactRow<Real>& row = contact.rows[i];
            row.total += row.lambda + row.bounce;
            row.totalFriction += row.friction;
        }
}

template <class Real>
void solveImpulses(Constraints<Real>& c, JointTrees& trees, std::span<Velocity<Real>> v,
                   const Settings& settings, Real h, std::vector<SweepReport>& report) {
    beginSolving(c, v, settings, h);
    const ExactVelocities<Real> exact(c, v, settings, h);
    warmStart(c, v, settings);
    trees.begin(settings.warmStart ? Real(1) : Real(0), static_cast<Real>(settings.baumgarte) / h, v);
    Settings enough = settings;
    if (solvedAtOnce(c, trees)) enough.sweeps = smaller(settings.sweeps, 1);
    sweepUntilSatisfied(enough, report, [&] {
        SweepReport swept = sweep(c, trees, v, settings);
        swept.distance = exact.distance(v);
        return swept;
    });
    bookImpulses(c);
}

#define ENGINE_INSTANTIATE(Real)                                                                \
    template void setBiases<Real>(Constraints<Real>&, std::span<const Velocity<Real>>,          \
                                  const Settings&, Real);                                       \
    template void warmStart<Real>(Constraints<Real>&, std::span<Velocity<Real>>,                \
                                  const Settings&);                                             \
    template SweepReport sweep<Real>(Constraints<Real>&, JointTrees&, std::span<Velocity<Real>>,\
                                     const Settings&);                                          \
    template void beginSolving<Real>(Constraints<Real>&, std::span<Velocity<Real>>,             \
                                     const Settings&, Real);                                    \
    template void bookImpulses<Real>(Constraints<Real>&);                                       \
    template void solveImpulses<Real>(Constraints<Real>&, JointTrees&,                          \
                                      std::span<Velocity<Real>>, const Settings&, Real,         \
                                      std::vector<SweepReport>&);
ENGINE_INSTANTIATE(float)
ENGINE_INSTANTIATE(double)
#undef ENGINE_INSTANTIATE

}  // namespace engine
