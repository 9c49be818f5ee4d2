#include "engine/solver/prepare.h"

#include <algorithm>

namespace engine {
namespace {

ContactGeometry<double> geometryOf(const Contact& contact, const ContactPoint& point,
                                   const Pose& a, const Pose& b) {
    const Vec3 onA = a.toWorld(point.anchorA), onB = b.toWorld(point.anchorB);
    const Vec3 middle = 0.5 * (onA + onB);
    return {middle - a.position, middle - b.position, contact.normal.dot(onB - onA)};
}

}  // namespace

void orderContacts(std::span<const Contact> contacts, const Bodies& bodies, const Vec3& gravity,
                   Order order, std::vector<int>& result) {
    result.resize(contacts.size());
    for (int i = 0; i < static_cast<int>(result.size()); ++i) result[i] = i;
    if (order == Order::pairs) return;
    const auto depth = [&](int i) {  // how far down: the first point stands for the contact
        return gravity.dot(bodies.poses[contacts[i].a].toWorld(contacts[i].points[0].anchorA));
    };
    std::sort(result.begin(), result.end(), [&](int i, int j) {
        const double x = depth(i), y = depth(j);
        return x < y || (x == y && i < j);
    });
}

void prepareContacts(std::span<const Contact> contacts, const Bodies& bodies, const Vec3& gravity,
                     const Settings& settings, Solver& solver) {
    Constraints<double>& c = solver.constraints;
    c.contacts.clear();
    solver.posesAtStart = bodies.poses;
    for (const Contact& contact : contacts) {
        ContactGeometry<double> points[Contact::kMaxPoints];
        for (int i = 0; i < contact.count; ++i)
            points[i] = geometryOf(contact, contact.points[i], bodies.poses[contact.a],
                                   bodies.poses[contact.b]);
        c.contacts.push_back(makeContactConstraint(contact, points,
                                                   bodies.inverseMasses[contact.a],
                                                   bodies.inverseMasses[contact.b]));
    }
    orderContacts(contacts, bodies, gravity, settings.order, c.order);
}

double separationNow(const ContactConstraint<double>& contact, const ContactRow<double>& row,
                     const Bodies& bodies, const Solver& solver) {
    const auto since = [&](int body) {
        const Pose &now = bodies.poses[body], &start = solver.posesAtStart[body];
        Quat turn = now.rotation * start.rotation.conjugate();
        if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
        return Velocity<double>{now.position - start.position, 2.0 * turn.vec()};
    };
    return row.gapAtStart +
           contact.n.dot(velocityBetween(row, since(contact.a), since(contact.b)));
}

void updateSeparations(const Bodies& bodies, Solver& solver) {
    for (ContactConstraint<double>& contact : solver.constraints.contacts)
        for (int i = 0; i < contact.count; ++i)
            contact.rows[i].separation =
                separationNow(contact, contact.rows[i], bodies, solver);
}

void storeImpulses(const Solver& solver, std::span<Contact> contacts) {
    for (int k = 0; k < static_cast<int>(contacts.size()); ++k) {
        const ContactConstraint<double>& c = solver.constraints.contacts[k];
        for (int i = 0; i < c.count; ++i) {
            contacts[k].points[i].impulse = c.rows[i].lambda;
            contacts[k].points[i].friction =
                c.rows[i].friction[0] * c.t1 + c.rows[i].friction[1] * c.t2;
        }
    }
}

}  // namespace engine
