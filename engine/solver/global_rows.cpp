#include "engine/solver/global_rows.h"

#include "engine/constraints/rolling.h"

namespace engine {
namespace {

template <class Real>
class Collector {
public:
    Collector(GlobalRows<Real>& rows, std::span<const Velocity<Real>> v, Real keep)
        : g_(rows), v_(v), keep_(keep) {}

    void add(const GlobalRow<Real>& row, Real bias, Real lambda) {
        g_.rows.push_back(row);
        g_.wanted.push_back(-(velocityAlong(row.row.j, v_[row.a], v_[row.b]) + bias) / g_.h);
        g_.force.push_back(keep_ * lambda / g_.h);
    }

    void add(const JointConstraint<Real>& joint, int place) {
        for (int i = 0; i < joint.count; ++i) {
            GlobalRow<Real> row{joint.rows[i], joint.a, joint.b};
            row.softness = joint.softness[i];
            row.joint = place;
            add(row, joint.bias[i], joint.lambda[i]);
        }
    }

    void add(const JointDrive<Real>& drive) {
        for (int i = 0; i < drive.count; ++i) {
            const DriveRow<Real>& of = drive.rows[i];
            GlobalRow<Real> row{drive.rowOf(of), drive.a, drive.b};
            row.softness = of.softness;
            row.most = of.high / g_.h;
            row.kind = of.kind == DriveKind::motor ? RowKind::hold
                       : of.low == Real(0)         ? RowKind::push
                                                   : RowKind::free;
            add(row, of.bias, of.lambda);
        }
    }

    void add(const ContactConstraint<Real>& contact) {
        const int first = g_.count();
        for (int i = 0; i < contact.count; ++i) {
            const ContactRow<Real>& point = contact.rows[i];
            GlobalRow<Real> row{rowAlong(contact, i, contact.n), contact.a, contact.b,
                                RowKind::push};
            add(row, point.bias, point.lambda);
        }
        for (int i = 0; i < contact.count; ++i) {
            const ContactRow<Real>& point = contact.rows[i];
            for (int t = 0; t < 2; ++t) {
                GlobalRow<Real> row{rowAlong(contact, i, t == 0 ? contact.t1 : contact.t2), contact.a,
                                    contact.b, RowKind::cone};
                row.mass = &point.frictionMass;
                row.normal = first + i, row.normals = 1;
                row.mu = contact.friction;
                row.bounce = point.bounce;
                add(row, Real(0), point.friction[t]);
            }
        }
        if (contact.rolling > Real(0)) addRolling(contact, first);
    }

    void addRolling(const ContactConstraint<Real>& contact, int firstNormal) {
        for (int t = 0; t < 2; ++t) {
            GlobalRow<Real> row{rowOfTurn(contact, t == 0 ? contact.t1 : contact.t2), contact.a,
                                contact.b, RowKind::cone};
            row.mass = &contact.rollingMass;
            row.normal = firstNormal, row.normals = contact.count;
            row.mu = contact.rolling;
            for (int i = 0; i < contact.count; ++i) row.bounce += contact.rows[i].bounce;
            add(row, Real(0), contact.rollingMoment[t]);
        }
    }

private:
    GlobalRows<Real>& g_;
    std::span<const Velocity<Real>> v_;
    Real keep_;
};

}  // namespace

template <class Real>
GlobalRows<Real> globalRows(const Constraints<Real>& c, std::span<const Velocity<Real>> v,
                            const Settings& settings, Real h) {
    GlobalRows<Real> g;
    g.h = h;
    Collector<Real> collector(g, v, settings.warmStart ? Real(1) : Real(0));
    for (int i = 0; i < static_cast<int>(c.joints.size()); ++i) collector.add(c.joints[i], i);
    for (const JointDrive<Real>& drive : c.drives) collector.add(drive);
    for (const int i : c.order) collector.add(c.contacts[i]);
    return g;
}

template <class Real>
void addAlongRows(const GlobalRows<Real>& g, std::span<const Real> lambda,
                  std::span<Velocity<Real>> v) {
    for (int i = 0; i < g.count(); ++i)
        apply(g.rows[i].row, lambda[i], v[g.rows[i].a], v[g.rows[i].b]);
}

template <class Real>
void takeForces(const GlobalRows<Real>& g, Constraints<Real>& c, std::span<Velocity<Real>> v) {
    int i = 0;
    for (JointConstraint<Real>& joint : c.joints)
        for (int k = 0; k < joint.count; ++k, ++i) {
            joint.lambda[k] = g.h * g.force[i];
            push(joint, k, joint.lambda[k], v[joint.a], v[joint.b]);
        }
    for (JointDrive<Real>& drive : c.drives)
        for (int k = 0; k < drive.count; ++k) {
            drive.rows[k].lambda = g.h * g.force[i++];
            push(drive, drive.rows[k], drive.rows[k].lambda, v[drive.a], v[drive.b]);
        }
    for (const int place : c.order) {
        ContactConstraint<Real>& contact = c.contacts[place];
        Velocity<Real>&a = v[contact.a], &b = v[contact.b];
        for (int k = 0; k < contact.count; ++k) contact.rows[k].lambda = g.h * g.force[i++];
        for (int k = 0; k < contact.count; ++k)
            for (int t = 0; t < 2; ++t) contact.rows[k].friction[t] = g.h * g.force[i++];
        for (int k = 0; k < contact.count; ++k)
            applyAt<Real>(contact, contact.rows[k], impulseOf(contact, contact.rows[k]), a, b);
        if (contact.rolling <= Real(0)) continue;
        for (int t = 0; t < 2; ++t) contact.rollingMoment[t] = g.h * g.force[i++];
        applyRolling<Real>(contact, contact.rollingMoment, a, b);
    }
}

#define ENGINE_INSTANTIATE(Real)                                                           \
    template GlobalRows<Real> globalRows<Real>(                                            \
        const Constraints<Real>&, std::span<const Velocity<Real>>, const Settings&, Real); \
    template void addAlongRows<Real>(const GlobalRows<Real>&, std::span<const Real>,       \
                                     std::span<Velocity<Real>>);                           \
    template void takeForces<Real>(const GlobalRows<Real>&, Constraints<Real>&,            \
                                   std::span<Velocity<Real>>);
ENGINE_INSTANTIATE(float)
ENGINE_INSTANTIATE(double)
#undef ENGINE_INSTANTIATE

}  // namespace engine
