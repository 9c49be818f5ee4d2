#include "engine/solver/global_rows.h"

#include "engine/constraints/rolling.h"

namespace engine {
namespace {

class Collector {
public:
    Collector(GlobalRows& rows, std::span<const Velocity> v, double keep)
        : g_(rows), v_(v), keep_(keep) {}

    void add(const GlobalRow& row, double bias, double lambda) {
        g_.rows.push_back(row);
        g_.wanted.push_back(-(velocityAlong(row.row.j, v_[row.a], v_[row.b]) + bias) / g_.h);
        g_.force.push_back(keep_ * lambda / g_.h);
    }

    void add(const JointConstraint& joint, int place) {
        for (int i = 0; i < joint.count; ++i) {
            GlobalRow row{joint.rows[i], joint.a, joint.b};
            row.softness = joint.softness[i];
            row.joint = place;
            add(row, joint.bias[i], joint.kept * joint.lambda[i]);
        }
    }

    void add(const JointDrive& drive) {
        for (int i = 0; i < drive.count; ++i) {
            const DriveRow& of = drive.rows[i];
            GlobalRow row{drive.rowOf(of), drive.a, drive.b};
            row.softness = of.softness;
            row.most = of.high / g_.h;
            row.kind = of.kind == DriveKind::motor ? RowKind::hold
                       : of.low == 0.0             ? RowKind::push
                                                   : RowKind::free;
            add(row, of.bias, of.lambda);
        }
    }

    void add(const ContactConstraint& contact) {
        const int first = g_.count();
        for (int i = 0; i < contact.count; ++i) {
            const ContactRow& point = contact.rows[i];
            GlobalRow row{rowAlong(contact, i, contact.n), contact.a, contact.b, RowKind::push};
            add(row, point.bias, point.lambda);
        }
        for (int i = 0; i < contact.count; ++i) {
            const ContactRow& point = contact.rows[i];
            for (int t = 0; t < 2; ++t) {
                GlobalRow row{rowAlong(contact, i, t == 0 ? contact.t1 : contact.t2), contact.a,
                              contact.b, RowKind::cone};
                row.mass = &point.frictionMass;
                row.normal = first + i, row.normals = 1;
                row.mu = contact.friction;
                row.bounce = point.bounce;
                add(row, -contact.lead[t], point.friction[t]);
            }
        }
        if (contact.rolling > 0.0) addRolling(contact, first);
    }

    void addRolling(const ContactConstraint& contact, int firstNormal) {
        for (int t = 0; t < 2; ++t) {
            GlobalRow row{rowOfTurn(contact, t == 0 ? contact.t1 : contact.t2), contact.a,
                          contact.b, RowKind::cone};
            row.mass = &contact.rollingMass;
            row.normal = firstNormal, row.normals = contact.count;
            row.mu = contact.rolling;
            for (int i = 0; i < contact.count; ++i) row.bounce += contact.rows[i].bounce;
            add(row, 0.0, contact.rollingMoment[t]);
        }
    }

private:
    GlobalRows& g_;
    std::span<const Velocity> v_;
    double keep_;
};

}  // namespace

GlobalRows globalRows(const Constraints& c, std::span<const Velocity> v, const Settings& settings,
                      double h) {
    GlobalRows g;
    g.h = h;
    Collector collector(g, v, settings.warmStart ? 1.0 : 0.0);
    for (int i = 0; i < static_cast<int>(c.joints.size()); ++i) collector.add(c.joints[i], i);
    for (const JointDrive& drive : c.drives) collector.add(drive);
    for (const int i : c.order) collector.add(c.contacts[i]);
    return g;
}

void addAlongRows(const GlobalRows& g, std::span<const double> lambda, std::span<Velocity> v) {
    for (int i = 0; i < g.count(); ++i)
        apply(g.rows[i].row, lambda[i], v[g.rows[i].a], v[g.rows[i].b]);
}

void takeForces(const GlobalRows& g, Constraints& c, std::span<Velocity> v) {
    int i = 0;
    for (JointConstraint& joint : c.joints)
        for (int k = 0; k < joint.count; ++k, ++i) {
            joint.lambda[k] = g.h * g.force[i];
            push(joint, k, joint.lambda[k], v[joint.a], v[joint.b]);
        }
    for (JointDrive& drive : c.drives)
        for (int k = 0; k < drive.count; ++k) {
            drive.rows[k].lambda = g.h * g.force[i++];
            push(drive, drive.rows[k], drive.rows[k].lambda, v[drive.a], v[drive.b]);
        }
    for (const int place : c.order) {
        ContactConstraint& contact = c.contacts[place];
        Velocity &a = v[contact.a], &b = v[contact.b];
        for (int k = 0; k < contact.count; ++k) contact.rows[k].lambda = g.h * g.force[i++];
        for (int k = 0; k < contact.count; ++k)
            for (int t = 0; t < 2; ++t) contact.rows[k].friction[t] = g.h * g.force[i++];
        for (int k = 0; k < contact.count; ++k)
            applyAt(contact, contact.rows[k], impulseOf(contact, contact.rows[k]), a, b);
        if (contact.rolling <= 0.0) continue;
        for (int t = 0; t < 2; ++t) contact.rollingMoment[t] = g.h * g.force[i++];
        applyRolling(contact, contact.rollingMoment, a, b);
    }
}

}  // namespace engine
