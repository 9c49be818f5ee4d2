#include "engine/solver/fresh_start.h"

#include "engine/constraints/rolling.h"

namespace engine {
namespace {

void forget(ContactConstraint& c) {
    for (ContactRow& row : c.rows) row.lambda = 0.0, row.friction.setZero();
    c.rollingMoment.setZero();
}

}  // namespace

double broughtBy(const ContactConstraint& c, const Velocity& a, const Velocity& b) {
    double sum = 0.0;
    for (int i = 0; i < c.count; ++i) {
        const ContactRow& row = c.rows[i];
        sum += impulseOf(c, row).dot(velocityBetween(row, a, b));
        sum += row.lambda * row.bias - row.friction.dot(c.lead);
    }
    const Vec3 turn = b.angular - a.angular;
    return sum + c.rollingMoment[0] * c.t1.dot(turn) + c.rollingMoment[1] * c.t2.dot(turn);
}

void takeBack(ContactConstraint& c, std::span<Velocity> v) {
    Velocity changeA, changeB;
    applyAll(c, changeA, changeB);
    v[c.a].linear -= changeA.linear, v[c.a].angular -= changeA.angular;
    v[c.b].linear -= changeB.linear, v[c.b].angular -= changeB.angular;
    forget(c);
}

void FreshStart::measure(const Constraints& c, std::span<const int> contacts,
                         const ContactGroups& groups, std::span<const Velocity> v) {
    brought_.resize(v.size()), changes_.resize(v.size());
    for (const int i : contacts) {
        brought_[groups.islandOf(i)] = 0.0;
        changes_[c.contacts[i].a] = changes_[c.contacts[i].b] = {};
    }
    for (const int i : contacts)
        applyAll(c.contacts[i], changes_[c.contacts[i].a], changes_[c.contacts[i].b]);
    const auto midway = [&](int body) {
        return Velocity{v[body].linear - 0.5 * changes_[body].linear, v[body].angular - 0.5 * changes_[body].angular};
    };
    for (const int i : contacts)
        brought_[groups.islandOf(i)] += broughtBy(c.contacts[i], midway(c.contacts[i].a), midway(c.contacts[i].b));
}

bool FreshStart::takeBack(Constraints& c, std::span<const int> contacts, const ContactGroups& groups,
                          std::span<Velocity> v) {
    measure(c, contacts, groups, v);
    bool any = false;
    for (const int i : contacts) {
        if (!(brought_[groups.islandOf(i)] > 0.0)) continue;
        any = true;
        forget(c.contacts[i]);
        for (const int body : {c.contacts[i].a, c.contacts[i].b}) {
            v[body].linear -= changes_[body].linear, v[body].angular -= changes_[body].angular;
            changes_[body] = {};
        }
    }
    return any;
}

}  // namespace engine
