#include "engine/solver/conjugate_joints.h"

namespace engine {
namespace {

constexpr double kParallel = 1e-9;  // squared sine between the sweep and the last step: they are the same

/// Calls visit(lambda, bias, softness) for all rows of a group, always in the same order.
template <class Visit>
void eachRow(const Constraints& c, JointTrees& trees, int group, const Visit& visit) {
    trees.eachJoint(group, [&]<int N>(TreeJoint<N>& joint, const InverseMass&, const InverseMass&) {
        for (int i = 0; i < N; ++i) visit(joint.lambda[i], trees.biasRate() * joint.now.error[i] + joint.bend[i], joint.softness[i]);
    });
    for (const int k : c.jointsOutside.of(group)) {
        const JointConstraint& joint = c.joints[k];
        for (int i = 0; i < joint.count; ++i) visit(joint.lambda[i], joint.bias[i], joint.softness[i]);
    }
}

/// Adds the impulse next() to each row, in the same order.
template <class Next>
void push(Constraints& c, JointTrees& trees, int group, std::span<Velocity> v, const Next& next) {
    trees.eachJoint(group, [&]<int N>(TreeJoint<N>& joint, const InverseMass& a, const InverseMass& b) {
        TreeRows<N> lambda;
        for (int i = 0; i < N; ++i) lambda[i] = next();
        book(joint, lambda, 1.0);
        apply(joint, lambda, a, b, v[joint.a], v[joint.b]);
    });
    for (const int k : c.jointsOutside.of(group)) {
        JointConstraint& joint = c.joints[k];
        for (int i = 0; i < joint.count; ++i) {
            const double lambda = next();
            joint.lambda[i] += lambda;
            push(joint, i, lambda, v[joint.a], v[joint.b]);
        }
    }
}

Velocity minus(const Velocity& x, const Velocity& y) {
    return {x.linear - y.linear, x.angular - y.angular};
}

}  // namespace

void ConjugateJoints::add(int body) {
    if (isThere_[body] || masses_[body].linear == 0.0) return;
    isThere_[body] = 1;
    Body& made = bodies_.emplace_back();
    made.number = body;
    made.mass = 1.0 / masses_[body].linear;
    made.inertia = masses_[body].angular.inverse();
}

void ConjugateJoints::begin(Constraints& c, JointTrees& trees, int group, std::span<Velocity> v) {
    rows_.clear(), bodies_.clear();
    isThere_.assign(masses_.size(), 0);
    for (const int k : c.jointsByGroup.of(group)) add(c.joints[k].a), add(c.joints[k].b);
    eachRow(c, trees, group, [&](double lambda, double bias, double softness) {
        rows_.push_back({0.0, 0.0, lambda, bias, softness});
    });
    for (Body& body : bodies_) body.step = v[body.number];
    std::size_t k = 0;
    push(c, trees, group, v, [&] { return -rows_[k++].step; });
    for (Body& body : bodies_) {
        body.at = v[body.number];
        body.step = minus(body.step, body.at);
    }
}

ConjugateJoints::Shares ConjugateJoints::bestShares() const {
    double dd = 0.0, dp = 0.0, pp = 0.0, d = 0.0, p = 0.0;
    for (const Row& row : rows_) {
        const double slope = row.bias + row.softness * row.at;
        d -= row.swept * slope, p -= row.step * slope;
        dd += row.softness * row.swept * row.swept;
        dp += row.softness * row.swept * row.step;
        pp += row.softness * row.step * row.step;
    }
    for (const Body& body : bodies_) {
        const Vec3 dLinear = body.mass * body.swept.linear, pLinear = body.mass * body.step.linear;
        const Vec3 dAngular = body.inertia * body.swept.angular, pAngular = body.inertia * body.step.angular;
        d -= dLinear.dot(body.at.linear) + dAngular.dot(body.at.angular);
        p -= pLinear.dot(body.at.linear) + pAngular.dot(body.at.angular);
        dd += dLinear.dot(body.swept.linear) + dAngular.dot(body.swept.angular);
        dp += dLinear.dot(body.step.linear) + dAngular.dot(body.step.angular);
        pp += pLinear.dot(body.step.linear) + pAngular.dot(body.step.angular);
    }
    const double determinant = dd * pp - dp * dp;
    if (determinant > kParallel * dd * pp)
        return {(d * pp - p * dp) / determinant, (p * dd - d * dp) / determinant};
    return dd > 0.0 ? Shares{d / dd, 0.0} : Shares{};
}

void ConjugateJoints::goOn(Constraints& c, JointTrees& trees, int group, std::span<Velocity> v) {
    trees.solveBack(group, v);
    std::size_t k = 0;
    eachRow(c, trees, group, [&](double lambda, double, double) {
        rows_[k].swept = lambda - rows_[k].at;
        ++k;
    });
    for (Body& body : bodies_) body.swept = minus(v[body.number], body.at);
    const Shares best = bestShares();
    k = 0;
    push(c, trees, group, v, [&] {
        Row& row = rows_[k++];
        row.step = best.alpha * row.swept + best.beta * row.step;
        row.at += row.step;
        return row.step - row.swept;
    });
    for (Body& body : bodies_) {
        body.step = minus(v[body.number], body.at);  // not by alpha and beta: round-off would grow from step to step
        body.at = v[body.number];
    }
}

}  // namespace engine
