#include "engine/solver/impulses.h"

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

template <class Real>
void sweepJoint(JointConstraint<Real>& joint, std::span<Velocity<Real>> v,
                Correction<Real>& correction) {
    for (int i = 0; i < joint.count; ++i) {
        const Row<Real>& row = joint.rows[i];
        const Real lambda = correctiveImpulse(row, joint.bias[i], v[joint.a], v[joint.b]);
        joint.lambda[i] += lambda;
        push(joint, i, lambda, v[joint.a], v[joint.b]);
        correction.add(row.k * lambda, lambda);
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
}

}  // namespace

template <class Real>
void setBiases(Constraints<Real>& c, std::span<const Velocity<Real>> v, const Settings& settings,
               Real h) {
    for (ContactConstraint<Real>& contact : c.contacts)
        for (int i = 0; i < contact.count; ++i) {
            ContactRow<Real>& row = contact.rows[i];
            const Real approach = velocityAlong(row.normal.j, v[contact.a], v[contact.b]);
            row.bias = biasOf(row, contact.restitution, approach, settings, h);
            row.bounce = Real(0);
        }
    const Real share = static_cast<Real>(settings.baumgarte) / h;
    for (JointConstraint<Real>& joint : c.joints)
        for (int i = 0; i < joint.count; ++i) joint.bias[i] = share * joint.error[i];
}

template <class Real>
void warmStart(Constraints<Real>& c, std::span<Velocity<Real>> v, const Settings& settings) {
    const Real keep = settings.warmStart && settings.accumulate ? Real(1) : Real(0);
    for (JointConstraint<Real>& joint : c.joints)
        for (int i = 0; i < joint.count; ++i) {
            joint.lambda[i] *= keep;
            push(joint, i, joint.lambda[i], v[joint.a], v[joint.b]);
        }
    for (ContactConstraint<Real>& contact : c.contacts)
        for (int i = 0; i < contact.count; ++i) {
            ContactRow<Real>& row = contact.rows[i];
            row.lambda *= keep;
            row.friction *= keep;
            apply(row.normal, row.lambda, v[contact.a], v[contact.b]);
            for (int t = 0; t < 2; ++t)
                apply(row.tangent[t], row.friction[t], v[contact.a], v[contact.b]);
        }
}

template <class Real>
SweepReport sweep(Constraints<Real>& c, JointTrees& trees, std::span<Velocity<Real>> v,
                  const Settings& settings) {
    Correction<Real> correction;
    for (JointConstraint<Real>& joint : c.joints)
        if (!joint.inTree) sweepJoint(joint, v, correction);
    trees.solveVelocities(c.joints, v, correction);
    for (const int i : c.order) sweepContact(c.contacts[i], v, settings, correction);
    return {static_cast<double>(correction.velocity), static_cast<double>(correction.impulse)};
}

template <class Real>
void solveImpulses(Constraints<Real>& c, JointTrees& trees, std::span<Velocity<Real>> v,
                   const Settings& settings, Real h, std::vector<SweepReport>& report) {
    setBiases<Real>(c, v, settings, h);
    if (settings.bounce == Bounce::impacts) solveImpacts(c, v, settings, h);
    warmStart(c, v, settings);
    for (int i = 0; i < settings.sweeps; ++i) {
        report.push_back(sweep(c, trees, v, settings));
        const bool enough = i + 1 >= settings.minSweeps;
        if (enough && report.back().residual < settings.tolerance) break;
    }
    for (ContactConstraint<Real>& contact : c.contacts)
        for (int i = 0; i < contact.count; ++i) {
            ContactRow<Real>& row = contact.rows[i];
            row.total += row.lambda + row.bounce;
            row.totalFriction += row.friction;
        }
}

#define ENGINE_INSTANTIATE(Real)                                                                \
    template void setBiases<Real>(Constraints<Real>&, std::span<const Velocity<Real>>,          \
                                  const Settings&, Real);                                       \
    template void warmStart<Real>(Constraints<Real>&, std::span<Velocity<Real>>,                \
                                  const Settings&);                                             \
    template SweepReport sweep<Real>(Constraints<Real>&, JointTrees&, std::span<Velocity<Real>>,\
                                     const Settings&);                                          \
    template void solveImpulses<Real>(Constraints<Real>&, JointTrees&,                          \
                                      std::span<Velocity<Real>>, const Settings&, Real,         \
                                      std::vector<SweepReport>&);
ENGINE_INSTANTIATE(float)
ENGINE_INSTANTIATE(double)
#undef ENGINE_INSTANTIATE

}  // namespace engine
