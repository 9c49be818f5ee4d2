#include "engine/solver/joined_start.h"

#include <algorithm>

#include "engine/solver/solver.h"

namespace engine {
namespace {

std::span<const int> contactsOf(const Solver& s, int group) {
    if (s.lanes) return {};
    const std::span<const int> order = s.constraints.order;
    return order.subspan(s.firstOfGroup[group], s.firstOfGroup[group + 1] - s.firstOfGroup[group]);
}

void takeBackJoint(JointConstraint& joint, std::span<Velocity> v) {
    for (int i = 0; i < joint.count; ++i) {
        push(joint, i, -joint.lambda[i], v[joint.a], v[joint.b]);
        joint.lambda[i] = 0.0;
    }
}

template <int N>
void takeBackTree(TreeJoint<N>& joint, const InverseMass& a, const InverseMass& b, std::span<Velocity> v) {
    const TreeRows<N> lambda = -joint.lambda;
    apply(joint, lambda, a, b, v[joint.a], v[joint.b]);
    book(joint, lambda, 1.0);
}

void takeBackDrive(JointDrive& drive, std::span<Velocity> v) {
    for (DriveRow& row : std::span(drive.rows).first(drive.count)) {
        push(drive, row, -row.lambda, v[drive.a], v[drive.b]);
        row.lambda = 0.0;
    }
}

}  // namespace

void JoinedStart::begin(const Solver& s, std::span<const Velocity> v) {
    const Constraints& c = s.constraints;
    start_.resize(v.size()), brought_.resize(v.size());
    const auto note = [&](const auto& pair) {
        if (pair.stride > 0) start_[pair.a] = v[pair.a], start_[pair.b] = v[pair.b];
    };
    std::ranges::for_each(c.joints, note);
    std::ranges::for_each(c.drives, note);
    std::ranges::for_each(c.contacts, note);
}

Velocity JoinedStart::midway(int body, std::span<const Velocity> v) const {
    return {0.5 * (start_[body].linear + v[body].linear), 0.5 * (start_[body].angular + v[body].angular)};
}

void JoinedStart::measure(Solver& s, int group, const Bodies& bodies) {
    Constraints& c = s.constraints;
    const std::span<const Velocity> v = bodies.velocities;
    const auto islandOf = [&](int a, int b) -> double& { return brought_[s.islands.leaderOf(bodies.movable(a, b))]; };
    s.trees.eachJoint(group, [&](const auto& joint, const InverseMass&, const InverseMass&) {
        const auto rate = velocityAlong(joint, midway(joint.a, v), midway(joint.b, v));
        islandOf(joint.a, joint.b) += joint.lambda.dot(rate + s.trees.biasRate() * joint.now.error + joint.bend +
                                                       0.5 * joint.softness.cwiseProduct(joint.lambda));
    });
    const auto add = [&](const Row& row, double sign, double lambda, double bias, double softness, int a, int b) {
        const double rate = sign * velocityAlong(row.j, midway(a, v), midway(b, v));
        islandOf(a, b) += lambda * (rate + bias + 0.5 * softness * lambda);
    };
    for (const int k : c.jointsOutside.of(group)) {
        const JointConstraint& joint = c.joints[k];
        for (int i = 0; i < joint.count; ++i)
            add(joint.rows[i], 1.0, joint.lambda[i], joint.bias[i], joint.softness[i], joint.a, joint.b);
    }
    for (const int k : c.drivesByGroup.of(group)) {
        const JointDrive& drive = c.drives[k];
        for (const DriveRow& row : std::span(drive.rows).first(drive.count))
            add(drive.alongOf(row), row.sign, row.lambda, row.bias, row.softness, drive.a, drive.b);
    }
    for (const int i : contactsOf(s, group))
        brought_[s.groups.islandOf(i)] +=
            broughtBy(c.contacts[i], midway(c.contacts[i].a, v), midway(c.contacts[i].b, v));
    if (s.lanes) s.wide.addBrought(group, brought_);
}

void JoinedStart::findIslands(Solver& s, int group, const Bodies& bodies) {
    const Constraints& c = s.constraints;
    islands_.clear();
    const auto add = [&](const auto& pair) { islands_.push_back(s.islands.leaderOf(bodies.movable(pair.a, pair.b))); };
    for (const int k : c.jointsByGroup.of(group)) add(c.joints[k]);
    for (const int k : c.drivesByGroup.of(group)) add(c.drives[k]);
    for (const int body : s.groups.jointedBodies(group)) islands_.push_back(s.islands.leaderOf(body));
    for (const int island : islands_) brought_[island] = 0.0;
}

bool JoinedStart::takeBack(Solver& s, int group, Bodies& bodies) {
    Constraints& c = s.constraints;
    const std::span<Velocity> v = bodies.velocities;
    const std::span<const int> shared = s.groups.jointedBodies(group);
    if (s.lanes) s.wide.give(v, shared);
    findIslands(s, group, bodies);
    measure(s, group, bodies);
    if (std::ranges::none_of(islands_, [&](int island) { return brought_[island] > 0.0; })) return false;
    const auto bad = [&](const auto& pair) { return brought_[s.islands.leaderOf(bodies.movable(pair.a, pair.b))] > 0.0; };
    s.trees.eachJoint(group, [&](auto& joint, const InverseMass& massA, const InverseMass& massB) {
        if (bad(joint)) takeBackTree(joint, massA, massB, v);
    });
    for (const int k : c.jointsOutside.of(group))
        if (bad(c.joints[k])) takeBackJoint(c.joints[k], v);
    for (const int k : c.drivesByGroup.of(group))
        if (bad(c.drives[k])) takeBackDrive(c.drives[k], v);
    for (const int i : contactsOf(s, group))
        if (bad(c.contacts[i])) engine::takeBack(c.contacts[i], v);
    if (!s.lanes) return true;
    s.wide.withdraw(group, brought_);
    s.wide.give(v, shared);
    return true;
}

}  // namespace engine
