#include "engine/solver/impacts.h"

#include "engine/dynamics/rotation.h"

namespace engine {
namespace {

/// An impact travels through n balls and back in n passes; the sweeps handle the rest.
constexpr int kPasses = 64;
constexpr double kLeaves = 1e9;    // m/s
constexpr double kMostTurn = 0.2;  // rad: larger rotations cannot be added

ContactImpact impactOf(const Contact& contact, int number, const Bodies& bodies) {
    ContactImpact impact;
    impact.number = number;
    ContactConstraint& c = impact.contact;
    c.a = contact.a, c.b = contact.b, c.count = contact.count;
    c.n = contact.normal, c.restitution = contact.restitution;
    const Pose &a = bodies.poses[c.a], &b = bodies.poses[c.b];
    for (int i = 0; i < c.count; ++i) {
        ContactRow& row = c.rows[i];
        const Vec3 onA = a.toWorld(contact.points[i].anchorA);
        const Vec3 onB = b.toWorld(contact.points[i].anchorB);
        row.armA = onA - a.position, row.armB = onB - b.position;
        row.gapAtStart = c.n.dot(onB - onA);
    }
    return impact;
}

Velocity since(const Pose& now, const Pose& start) {
    return {now.position - start.position, turnBetween(start, now)};
}

/// The impact of a point within a sub-step.
struct Meeting {
    bool hits = false;
    double time = 0.0;   // s
    double speed = 0.0;  // u, m/s
};

Meeting meet(double approach, double gap, double acceleration, double earliest, double threshold,
             double h) {
    Meeting m;
    const double start = approach - 0.5 * h * acceleration;
    const double open = larger(gap, 0.0);
    m.speed = -std::sqrt(larger(start * start - 2.0 * acceleration * open, 0.0));
    m.hits = gap + h * approach <= 0.0 && m.speed < -threshold && approach < 0.0;
    const double sum = -start - m.speed;
    m.time = clamped(sum > 0.0 ? 2.0 * open / sum : h, earliest, h);
    return m;
}

}  // namespace

void Impacts::prepare(std::span<const Contact> contacts, const Bodies& bodies) {
    list_.clear();
    for (std::size_t k = 0; k < contacts.size(); ++k)
        if (contacts[k].restitution > 0.0)
            list_.push_back(impactOf(contacts[k], static_cast<int>(k), bodies));
    for (const int i : met_) bodies_[i] = {};
    met_.clear();
    bodies_.resize(larger(bodies_.size(), list_.empty() ? 0 : bodies.poses.size()));
}

void Impacts::begin(const Bodies& bodies, std::span<const Pose> posesAtStart) {
    for (const int i : met_) bodies_[i] = {};
    met_.clear();
    all_ = &bodies, starts_ = posesAtStart;
    for (ContactImpact& impact : list_) {
        impact.placed = false;
        for (int i = 0; i < impact.contact.count; ++i) impact.contact.rows[i].bounce = 0.0;
    }
}

void Impacts::place(ContactImpact& impact) const {
    ContactConstraint& c = impact.contact;
    const Velocity wayA = since(all_->poses[c.a], starts_[c.a]);
    const Velocity wayB = since(all_->poses[c.b], starts_[c.b]);
    const Acceleration &a = all_->accelerations[c.a], &b = all_->accelerations[c.b];
    c.massA = all_->inverseMasses[c.a], c.massB = all_->inverseMasses[c.b];
    Row normals[Contact::kMaxPoints];
    for (int i = 0; i < c.count; ++i) {
        ContactRow& row = c.rows[i];
        row.separation = row.gapAtStart + c.n.dot(velocityBetween(row, wayA, wayB));
        impact.acceleration[i] =
            c.n.dot(velocityBetween(row, {a.linear, a.angular}, {b.linear, b.angular}));
        normals[i] = rowAlong(c, i, c.n);
    }
    c.block = makeNormalBlock(c.count, [&](int i) -> const Row& { return normals[i]; });
    impact.placed = true;
}

bool Impacts::bounce(ContactImpact& impact, std::span<Velocity> v, double threshold, double h) {
    ContactConstraint& c = impact.contact;
    Velocity &a = v[c.a], &b = v[c.b];
    Body &bodyA = bodies_[c.a], &bodyB = bodies_[c.b];
    double approach[Contact::kMaxPoints], fastest = 0.0;
    for (int i = 0; i < c.count; ++i) {
        approach[i] = c.n.dot(velocityBetween(c.rows[i], a, b));
        fastest = smaller(fastest, approach[i]);
    }
    if (fastest > -0.5 * threshold) return false;  // most contacts rest
    if (!impact.placed) place(impact);
    const double earliest = larger(bodyA.time, bodyB.time);
    Meeting meetings[Contact::kMaxPoints];
    double time = h;
    bool any = false;
    for (int i = 0; i < c.count; ++i) {
        const ContactRow& row = c.rows[i];
        const double gap = row.separation + c.n.dot(velocityBetween(row, bodyA.way, bodyB.way));
        meetings[i] = meet(approach[i], gap, impact.acceleration[i], earliest, threshold, h);
        if (!meetings[i].hits) continue;
        any = true;
        time = smaller(time, meetings[i].time);
    }
    if (!any) return false;
    // w = K lambda + q >= 0: the bounce speed where the two hit, and no approach where they only come near.
    // Separating points are ignored: with w = 0 there, Newton's law would add lambda u / 2 to the energy.
    Vec4 q = Vec4::Zero();
    for (int i = 0; i < c.count; ++i)
        q[i] = meetings[i].hits ? approach[i] + c.restitution * meetings[i].speed -
                                      impact.acceleration[i] * (0.5 * h - time)
                 : approach[i] > 0.0 ? kLeaves
                                     : 0.0;
    const Vec4 lambda = solveNormalBlock(c.block, q);
    for (int i = 0; i < c.count; ++i) {
        c.rows[i].bounce += lambda[i];
        applyAt(c, c.rows[i], lambda[i] * c.n, a, b);
        applyAt(c, c.rows[i], -time * lambda[i] * c.n, bodyA.way, bodyB.way);
    }
    for (const auto& [mass, index] : {std::pair(&c.massA, c.a), std::pair(&c.massB, c.b)}) {
        if (mass->linear == 0.0) continue;
        bodies_[index].time = time;
        if (!bodies_[index].met) met_.push_back(index);
        bodies_[index].met = true;
    }
    return true;
}

void Impacts::solve(std::span<Velocity> v, const Settings& settings) {
    if (settings.bounce != Bounce::impacts) return;
    bool any = true;
    for (int pass = 0; pass < kPasses && any; ++pass) {
        any = false;
        for (ContactImpact& impact : list_) {
            const int body = all_->movable(impact.contact.a, impact.contact.b);
            if (!all_->acts[body]) continue;
            any = bounce(impact, v, settings.bounceSpeed, all_->spans[body]) || any;
        }
    }
}

void Impacts::movePositions(Bodies& bodies) const {
    for (const int i : met_) {
        bodies.poses[i].position += bodies_[i].way.linear;
        const Vec3& turn = bodies_[i].way.angular;
        if (turn.norm() < kMostTurn) turnTo(turnedBy(turn, bodies.poses[i].rotation), i, bodies);
    }
}

}  // namespace engine
