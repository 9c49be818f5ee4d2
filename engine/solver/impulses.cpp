#include "engine/solver/impulses.h"

#include "engine/constraints/rolling.h"
#include "engine/solver/block_factors.h"
#include "engine/solver/drives.h"
#include "engine/solver/exact_velocities.h"
#include "engine/solver/impacts.h"

namespace engine {
namespace {

double biasOf(const ContactRow& row, double restitution, double approach, const Settings& settings,
              double h) {
    const double slop = settings.slop;
    const bool touches = row.separation + h * approach <= 0.0;
    if (settings.bounce == Bounce::bias && restitution > 0.0 && touches &&
        approach < -settings.bounceSpeed)
        return restitution * approach;
    if (row.separation > 0.0) return row.separation / h;
    if (row.separation < -slop) return settings.baumgarte * (row.separation + slop) / h;
    return 0.0;
}

/// (J M^-1 J^T)^-1 for all rows.
Eigen::Matrix<double, 6, 6> massOf(const JointConstraint& joint) {
    Eigen::Matrix<double, 6, 6> k = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> scale = Eigen::Matrix<double, 6, 1>::Zero();
    for (int i = 0; i < joint.count; ++i) {
        for (int l = 0; l < joint.count; ++l) k(i, l) = coupling(joint.rows[i], joint.rows[l]);
        k(i, i) += joint.softness[i];
        scale[i] = k(i, i);
    }
    sweepPivots<6>(k, scale);
    return k;
}

/// The share of the impulses that a joint outside the trees starts from, because its rows turn with its
/// bodies. With the full impulses, few sweeps give spinning bodies of unequal masses more energy in a step.
double keptInTurn(const Velocity& a, const Velocity& b, double h) {
    constexpr double kStraight = 0.02, kMostLost = 0.1;  // rad; share
    const double turn = h * larger(a.angular.norm(), b.angular.norm());
    return 1.0 - clamped(turn - kStraight, 0.0, kMostLost);
}

/// Sets b, softness, and the block of the point's rows, after the rows were made.
void setBiases(JointConstraint& joint, const Settings& settings, double h) {
    for (int i = 0; i < joint.count; ++i) {
        const SoftRow soft = joint.spring.isSoft()
                                 ? softRow(joint.springs[i], joint.rows[i].k, joint.error[i],
                                           joint.before[i], h, settings.springs)
                                 : SoftRow{0.0, settings.baumgarte * joint.error[i] / h + joint.bend[i]};
        joint.softness[i] = soft.softness;
        joint.bias[i] = soft.bias;
    }
    joint.allAtOnce = settings.block && !joint.inTree && joint.asBlock;
    if (joint.allAtOnce) joint.mass = massOf(joint);
    joint.pointAtOnce = settings.block && !joint.inTree && !joint.asBlock && joint.count >= 3;
    if (!joint.pointAtOnce) return;
    Mat3 k;
    for (int i = 0; i < 3; ++i)
        for (int l = 0; l < 3; ++l) k(i, l) = coupling(joint.rows[i], joint.rows[l]);
    for (int i = 0; i < 3; ++i) k(i, i) += joint.softness[i];
    joint.pointMass = k.inverse();
}

/// Solves the point's three rows together: lambda = -K^-1 (J v + b).
void sweepPoint(JointConstraint& joint, Velocity& a, Velocity& b, Correction& correction) {
    Vec3 left;
    for (int i = 0; i < 3; ++i)
        left[i] = velocityAlong(joint.rows[i].j, a, b) + joint.bias[i] +
                  joint.softness[i] * joint.lambda[i];
    const Vec3 lambda = -(joint.pointMass * left);
    for (int i = 0; i < 3; ++i) {
        joint.lambda[i] += lambda[i];
        push(joint, i, lambda[i], a, b);
        correction.add(left[i], lambda[i]);
    }
}

/// Solves all rows together.
void sweepWhole(JointConstraint& joint, Velocity& a, Velocity& b, Correction& correction) {
    Eigen::Matrix<double, 6, 1> left = Eigen::Matrix<double, 6, 1>::Zero();
    for (int i = 0; i < joint.count; ++i)
        left[i] = velocityAlong(joint.rows[i].j, a, b) + joint.bias[i] +
                  joint.softness[i] * joint.lambda[i];
    const Eigen::Matrix<double, 6, 1> lambda = -(joint.mass * left);
    for (int i = 0; i < joint.count; ++i) {
        joint.lambda[i] += lambda[i];
        push(joint, i, lambda[i], a, b);
        correction.add(left[i], lambda[i]);
    }
}

void sweepJoint(JointConstraint& joint, Velocity& a, Velocity& b, Correction& correction) {
    if (joint.allAtOnce) return sweepWhole(joint, a, b, correction);
    if (joint.pointAtOnce) sweepPoint(joint, a, b, correction);
    for (int i = joint.pointAtOnce ? 3 : 0; i < joint.count; ++i) {
        const Row& row = joint.rows[i];
        const double lambda =
            correctiveImpulse(row, joint.bias[i], joint.softness[i], joint.lambda[i], a, b);
        joint.lambda[i] += lambda;
        push(joint, i, lambda, a, b);
        correction.add((row.k + joint.softness[i]) * lambda, lambda);
    }
}

void sweepContact(ContactConstraint& contact, std::span<Velocity> v, const Settings& settings,
                  Correction& correction) {
    Velocity &a = v[contact.a], &b = v[contact.b];
    if (settings.block && settings.accumulate) {
        solveNormalsTogether(contact, a, b, correction);
        solveFrictionTogether(contact, a, b, correction);
    } else {
        solveNormals(contact, settings.accumulate, a, b, correction);
        solveFriction(contact, a, b, correction);
    }
    solveRolling(contact, a, b, correction);
}

/// Without `ahead`, a point that will touch after another one has bounced would be stopped before it bounces.
void setBounce(const ContactImpact& impact, int i, double h, ContactConstraint& contact) {
    ContactRow& row = contact.rows[i];
    row.bounce = impact.contact.rows[i].bounce;
    const double gap = row.separation;
    row.bias += (larger(gap + impact.ahead[i], 0.0) - larger(gap, 0.0)) / (contact.stride * h);
}

void setLead(const RidingContact& riding, ContactConstraint& contact) {
    contact.lead << contact.t1.dot(riding.lead), contact.t2.dot(riding.lead);
    const double angle = contact.n.dot(riding.turn);
    for (int i = 0; i < contact.count; ++i) {
        const Vec2 before = contact.rows[i].friction;
        contact.rows[i].friction += angle * Vec2(-before[1], before[0]);
    }
}

void warmStartJoints(Constraints& c, double keep, std::span<Velocity> v) {
    for (JointConstraint& joint : c.joints) {
        if (joint.inTree || joint.stride == 0) continue;
        for (int i = 0; i < joint.count; ++i) {
            joint.lambda[i] *= keep * joint.kept;
            push(joint, i, joint.lambda[i], v[joint.a], v[joint.b]);
        }
    }
    warmStartDrives(c, keep, v);
}

}  // namespace

void setBiases(Constraints& c, std::span<const Velocity> v, const Settings& settings, double h) {
    for (ContactConstraint& contact : c.contacts)
        for (int i = 0; contact.stride > 0 && i < contact.count; ++i) {
            ContactRow& row = contact.rows[i];
            const double approach = contact.n.dot(velocityBetween(row, v[contact.a], v[contact.b]));
            row.bias = biasOf(row, contact.restitution, approach, settings,
                              contact.stride * h);
            row.bounce = 0.0;
        }
    for (JointConstraint& joint : c.joints) {
        if (joint.stride == 0 || (joint.inTree && !settings.compareExact)) continue;
        setBiases(joint, settings, joint.stride * h);
        joint.kept = keptInTurn(v[joint.a], v[joint.b], joint.stride * h);
    }
    setDriveBiases(c, settings, h);
}

void warmStart(Constraints& c, std::span<Velocity> v, const Settings& settings) {
    const double keep = settings.warmStart && settings.accumulate ? 1.0 : 0.0;
    warmStartJoints(c, keep, v);
    for (ContactConstraint& contact : c.contacts) {
        if (contact.stride == 0) continue;
        for (int i = 0; i < contact.count; ++i) {
            contact.rows[i].lambda *= keep;
            contact.rows[i].friction *= keep;
        }
        contact.rollingMoment *= keep;
        applyAll(contact, v[contact.a], v[contact.b]);
    }
}

SweepReport sweepJoints(Constraints& c, JointTrees& trees, std::span<Velocity> v) {
    Correction correction;
    trees.solveVelocities(0, v, correction);
    for (JointConstraint& joint : c.joints)
        if (!joint.inTree) sweepJoint(joint, v[joint.a], v[joint.b], correction);
    for (JointDrive& drive : c.drives) sweepDrive(drive, v, correction);
    return {correction.velocity, correction.impulse};
}

SweepReport sweepJoints(Constraints& c, JointTrees& trees, TreeDrives& drives, int group, std::span<Velocity> v) {
    Correction correction;
    const std::span<const int> outside = c.jointsOutside.of(group);
    trees.solveVelocities(group, v, correction);
    for (const int i : outside) sweepJoint(c.joints[i], v[c.joints[i].a], v[c.joints[i].b], correction);
    drives.solve(group, !outside.empty(), c, trees, v, correction);
    return {correction.velocity, correction.impulse};
}

SweepReport sweepContacts(Constraints& c, std::span<const int> order, std::span<Velocity> v,
                          const Settings& settings) {
    Correction correction;
    for (const int i : order)
        if (c.contacts[i].stride > 0) sweepContact(c.contacts[i], v, settings, correction);
    return {correction.velocity, correction.impulse};
}

SweepReport together(const SweepReport& a, const SweepReport& b) {
    return {larger(a.residual, b.residual), a.delta + b.delta};
}

SweepReport sweep(Constraints& c, JointTrees& trees, std::span<Velocity> v,
                  const Settings& settings) {
    const SweepReport joints = sweepJoints(c, trees, v);
    return together(joints, sweepContacts(c, c.order, v, settings));
}

void beginSolving(Constraints& c, std::span<Velocity> v, const Settings& settings, double h) {
    c.impacts.solve(v, settings);
    setBiases(c, v, settings, h);
    if (c.contacts.empty()) return;  // contacts are in lanes
    for (const ContactImpact& impact : c.impacts.list())
        for (int i = 0; i < impact.contact.count; ++i)
            setBounce(impact, i, h, c.contacts[impact.number]);
    for (const RidingContact& riding : c.riding.list())
        setLead(riding, c.contacts[riding.number]);
}

void bookImpulses(Constraints& c) {
    for (ContactConstraint& contact : c.contacts)
        for (int i = 0; contact.stride > 0 && i < contact.count; ++i) {
            ContactRow& row = contact.rows[i];
            row.total += row.lambda + row.bounce;
            row.totalFriction += row.friction;
        }
}

void solveImpulses(Constraints& c, JointTrees& trees, std::span<Velocity> v,
                   const Settings& settings, double h, std::vector<SweepReport>& report) {
    beginSolving(c, v, settings, h);
    const ExactVelocities exact(c, v, settings, h);
    warmStart(c, v, settings);
    trees.begin(0, settings.warmStart ? 1.0 : 0.0, v);
    trees.setBiasRate(settings.baumgarte / h);
    Settings enough = settings;
    if (c.contacts.empty() && solvedAtOnce(c, trees)) enough.sweeps = smaller(settings.sweeps, 1);
    sweepUntilSatisfied(enough, report, [&] {
        SweepReport swept = sweep(c, trees, v, settings);
        swept.distance = exact.distance(v);
        return swept;
    });
    bookImpulses(c);
}

}  // namespace engine
