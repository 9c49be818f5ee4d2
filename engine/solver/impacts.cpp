#include "engine/solver/impacts.h"

#include <algorithm>
#include <array>

#include "engine/dynamics/rotation.h"

namespace engine {
namespace {

/// An impact travels through n balls and back in n passes; the sweeps handle the rest.
constexpr int kPasses = 64;
constexpr double kLeaves = 1e9;    // m/s
constexpr double kTogether = 1e-4;  // m: points this close when the first one of a contact touches bounce with it
constexpr double kSlides = 1e-3;    // m
constexpr double kRests = 1e-3;     // m in a sub-step: what rests falls by g h^2, much less

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
        row.armA = onA - a.position + contact.slideA;
        row.armB = onB - b.position + contact.slideB;
        row.gapAtStart = c.n.dot(onB - onA);
    }
    return impact;
}

/// Two movable bodies that hit each other obliquely and fast: only a bounce (of 0 m/s) puts them where they meet, and
/// keeps the angular momentum, as the arms are those of the impact. Not if one hangs on joints: a bounce does not
/// know the mass behind them, and in a cloth the order of its knots would show.
bool slides(const Contact& contact, std::span<const Joint> joints, const Bodies& bodies) {
    const auto joins = [&](const Joint& joint) {
        const int a = joint.def.a.index, b = joint.def.b.index;
        return a == contact.a || b == contact.a || a == contact.b || b == contact.b;
    };
    return (contact.slideB - contact.slideA).squaredNorm() > kSlides * kSlides &&
           bodies.inverseMasses[contact.a].linear > 0.0 && bodies.inverseMasses[contact.b].linear > 0.0 &&
           std::ranges::none_of(joints, joins);
}

Velocity since(const Pose& now, const Pose& start) {
    return {now.position - start.position, turnBetween(start, now)};
}

/// The impact of a point within a sub-step.
struct Meeting {
    bool hits = false;
    double time = 0.0;      // s
    double speed = 0.0;     // u, m/s
    double approach = 0.0;  // J v, m/s
    double gap = 0.0;       // C, m
};

struct Meetings {
    std::array<Meeting, Contact::kMaxPoints> points;
    double first = 0.0;  // s, time of the first impact
    bool any = false;
};

Meeting meet(double approach, double gap, double acceleration, double earliest, const Settings& settings,
             double h) {
    Meeting m;
    m.approach = approach, m.gap = gap;
    const double start = approach - 0.5 * h * acceleration;
    const double open = larger(gap, 0.0);
    // A point too deep arrived slower than it is now; nudges will lift it before it has left.
    const double fallen = gap < -settings.slop ? larger(gap + settings.slop, -settings.depenetrationSpeed * h) : open;
    m.speed = -std::sqrt(larger(start * start - 2.0 * acceleration * fallen, 0.0));
    m.hits = gap + h * approach <= 0.0 && m.speed < -settings.bounceSpeed && approach < 0.0;
    const double sum = -start - m.speed;
    m.time = clamped(sum > 0.0 ? 2.0 * open / sum : h, earliest, h);
    return m;
}

/// q in w = K lambda + q >= 0: the bounce speed of the points that touch at the first impact; no faster approach
/// where it is too slow to bounce. Separating points are ignored: with w = 0 there, Newton's law would add lambda u / 2
/// to the energy. So are points that touch later: holding them would take energy away.
Vec4 startOf(const ContactImpact& impact, const Meetings& meetings, double threshold, double h) {
    Vec4 q = Vec4::Constant(kLeaves);
    for (int i = 0; i < impact.contact.count; ++i) {
        const Meeting& m = meetings.points[i];
        if (m.approach > 0.0 || m.gap + meetings.first * m.approach > kTogether) continue;
        q[i] = m.speed < -threshold ? m.approach + impact.contact.restitution * m.speed -
                                          impact.acceleration[i] * (0.5 * h - meetings.first)
                                    : 0.0;
    }
    return q;
}

/// The block's diagonal is raised, which a sweep makes up for in the next one; there is only one bounce.
Vec4 solveToTheEnd(const NormalBlock& block, const Vec4& q) {
    constexpr int kMore = 2;  // each leaves a thousandth of the error
    Vec4 lambda = solveNormalBlock(block, q);
    const Vec4 raised = block.k.diagonal() - block.exact;
    for (int i = 0; i < kMore && block.count > 1; ++i)
        lambda = solveNormalBlock(block, q - raised.cwiseProduct(lambda));
    return lambda;
}

/// A rotation that was reached at the rate `spin` in h, as if `turn` had been added to its first part, until t.
Quat turnedAgain(const Vec3& turn, const Vec3& spin, double t, double h, const Quat& rotation) {
    const Quat sinceThen = turnedBy(Vec3((t - h) * spin), rotation);
    const Quat start = turnedBy(Vec3(-t * spin), sinceThen);
    return turnedBy(Vec3((h - t) * spin), turnedBy(Vec3(t * spin + turn), start));
}

}  // namespace

void Impacts::prepare(std::span<const Contact> contacts, std::span<const Joint> joints, const Bodies& bodies) {
    list_.clear();
    for (std::size_t k = 0; k < contacts.size(); ++k)
        if (contacts[k].restitution > 0.0 || slides(contacts[k], joints, bodies))
            list_.push_back(impactOf(contacts[k], static_cast<int>(k), bodies));
    met_.clear();
    if (list_.empty()) return;
    bodies_.assign(bodies.poses.size(), {});
    auto listed = list_.begin();
    for (int k = 0; k < static_cast<int>(contacts.size()); ++k)
        if (listed != list_.end() && listed->number == k)
            ++listed;
        else
            bodies_[contacts[k].a].touched = bodies_[contacts[k].b].touched = true;
    for (const Joint& joint : joints)
        if (joint.present) bodies_[joint.def.a.index].jointed = bodies_[joint.def.b.index].jointed = true;
}

void Impacts::begin(const Bodies& bodies, std::span<const Pose> posesAtStart) {
    for (const int i : met_) bodies_[i].beginSubstep();
    met_.clear();
    all_ = &bodies, starts_ = posesAtStart;
    for (ContactImpact& impact : list_) {
        impact.placed = false;
        for (int i = 0; i < impact.contact.count; ++i)
            impact.contact.rows[i].bounce = impact.ahead[i] = 0.0;
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

bool Impacts::bounce(ContactImpact& impact, std::span<Velocity> v, const Settings& settings, double h) {
    ContactConstraint& c = impact.contact;
    Velocity &a = v[c.a], &b = v[c.b];
    Body &bodyA = bodies_[c.a], &bodyB = bodies_[c.b];
    double approach[Contact::kMaxPoints], fastest = 0.0;
    for (int i = 0; i < c.count; ++i) {
        approach[i] = c.n.dot(velocityBetween(c.rows[i], a, b));
        fastest = smaller(fastest, approach[i]);
    }
    if (fastest > -0.5 * settings.bounceSpeed) return false;  // most contacts rest
    if (!impact.placed) place(impact);
    Meetings meetings{{}, h};
    for (int i = 0; i < c.count; ++i) {
        const double gap = c.rows[i].separation + c.n.dot(velocityBetween(c.rows[i], bodyA.way, bodyB.way));
        const Meeting& m = meetings.points[i] = meet(approach[i], gap, impact.acceleration[i],
                                                     larger(bodyA.time, bodyB.time), settings, h);
        if (m.hits) meetings.any = true, meetings.first = smaller(meetings.first, m.time);
    }
    if (!meetings.any) return false;
    const Vec4 lambda = solveToTheEnd(c.block, startOf(impact, meetings, settings.bounceSpeed, h));
    note(c.a, meetings.first, a, h);
    note(c.b, meetings.first, b, h);
    for (int i = 0; i < c.count; ++i) {
        c.rows[i].bounce += lambda[i];
        applyAt(c, c.rows[i], lambda[i] * c.n, a, b);
        applyAt(c, c.rows[i], -meetings.first * lambda[i] * c.n, bodyA.way, bodyB.way);
    }
    return true;
}

void Impacts::note(int i, double time, const Velocity& before, double h) {
    if (all_->inverseMasses[i].linear == 0.0) return;
    Body& body = bodies_[i];
    if (!body.met) met_.push_back(i), body.slow = h * before.linear.norm() < kRests;
    body.time = time, body.met = true;
}

void Impacts::solve(std::span<Velocity> v, const Settings& settings) {
    if (settings.bounce != Bounce::impacts) return;
    bool any = true;
    for (int pass = 0; pass < kPasses && any; ++pass) {
        any = false;
        for (ContactImpact& impact : list_) {
            const int body = all_->movable(impact.contact.a, impact.contact.b);
            if (!all_->acts[body]) continue;
            any = bounce(impact, v, settings, all_->spans[body]) || any;
        }
    }
    for (const int i : met_) bodies_[i].after = v[i];
    for (ContactImpact& impact : list_) {
        const ContactConstraint& c = impact.contact;
        for (int i = 0; i < c.count; ++i)
            impact.ahead[i] = c.n.dot(velocityBetween(c.rows[i], bodies_[c.a].way, bodies_[c.b].way));
    }
}

void Impacts::movePositions(Bodies& bodies) const {
    for (const int i : met_) {
        const Body& body = bodies_[i];
        const Velocity& end = bodies.velocities[i];
        Velocity way = body.way;
        if (body.isFree()) {
            way.linear -= body.time * (end.linear - body.after.linear);
            way.angular -= body.time * (end.angular - body.after.angular);
        }
        bodies.poses[i].position += way.linear;
        turnTo(turnedAgain(way.angular, end.angular, body.time, bodies.spans[i], bodies.poses[i].rotation), i, bodies);
    }
}

}  // namespace engine
