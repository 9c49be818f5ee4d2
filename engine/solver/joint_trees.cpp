#include "engine/solver/joint_trees.h"

namespace engine {
namespace {

template <int N>
void report(const TreeJoint<N>& t, double dt, Joint& joint) {
    joint.force = t.impulse / dt;
    joint.torque = t.torque / dt;
    if (!t.hasOwnRows) return;  // an exact solve needs no start values
    for (int i = 0; i < rowCount(t.type); ++i) joint.lambda[i] = t.lambda[i];
}

}  // namespace

void JointTrees::build(std::span<JointConstraint> list, std::span<const Joint> joints,
                       std::span<const InverseMass> masses) {
    forests_.clear(), order_.clear(), whole_.clear(), inLoops_.clear(), inNets_.clear();
    for (const ForestPlan& plan : planForests(list, masses)) {
        Forest& forest = forests_.emplace_back();
        forest.balls.build(plan, 0, list, joints);
        forest.hinges.build(plan, 3, list, joints);
        forest.welds.build(plan, 5, list, joints);
        for (const ForestPlan::Place& place : plan.places) {
            order_.push_back(place.joint);
            const ForestPlan::Tree& tree = plan.trees[place.tree];
            (tree.whole ? whole_ : inNets_).push_back(place.joint);
            if (tree.whole && tree.closed) inLoops_.push_back(place.joint);
        }
    }
    exactTrees_.assign(joints.size(), -1);
    if (!forests_.empty())
        forests_[0].each([&](auto& part) {
            for (const auto& joint : part.joints())
                if (part.isExact(joint.tree)) exactTrees_[joint.joint] = joint.tree;
        });
    sortInto(1, [](int, int) { return 0; });
}

void JointTrees::prepare(int group, std::span<const Joint> joints, const Bodies& bodies) {
    for (Forest& forest : forests_)
        forest.each([&](auto& part) {
            part.place(part.of(group), joints, bodies.poses);
            part.bend(part.of(group), joints, bodies);
            part.factor(part.of(group), bodies.inverseMasses);
        });
}

void JointTrees::begin(int group, double keep, std::span<Velocity> v) {
    for (Forest& forest : forests_)
        forest.each([&](auto& part) { part.warmStart(part.of(group), keep, v); });
}

void JointTrees::solveVelocities(int group, std::span<Velocity> v, Correction& correction) {
    Correction own;
    for (Forest& forest : forests_)
        forest.each([&](auto& part) { part.solveVelocities(part.of(group), biasRate_, v, own); });
    correction.add(isExact(group) ? 0.0 : own.velocity, own.impulse);
}

int JointTrees::exactTreeOf(int joint) const {
    return joint < static_cast<int>(exactTrees_.size()) ? exactTrees_[joint] : -1;
}

int JointTrees::jointsOf(int tree) const {
    int count = 0;
    forests_[0].each([&](const auto& part) { count += part.jointsOf(tree); });
    return count;
}

void JointTrees::respond(int tree, std::span<Velocity> v, std::vector<double>& impulses) {
    forests_[0].each([&](auto& part) { part.respond(tree, v, impulses); });
}

void JointTrees::bookResponse(int tree, std::span<const double> impulses, double share) {
    forests_[0].each([&](auto& part) { part.bookResponse(tree, impulses, share); });
}

void JointTrees::solveTree(int tree, std::span<Velocity> v) {
    Correction unused;
    forests_[0].each([&](auto& part) { part.solveVelocities(std::span(&tree, 1), biasRate_, v, unused); });
}

bool JointTrees::isNet(int group) const {
    bool any = false;
    for (std::size_t i = 1; i < forests_.size(); ++i)
        forests_[i].each([&](const auto& part) { any = any || !part.of(group).empty(); });
    return any;
}

void JointTrees::solveBack(int group, std::span<Velocity> v) {
    Correction unused;
    for (int i = static_cast<int>(forests_.size()) - 2; i >= 0; --i)
        forests_[i].each([&](auto& part) { part.solveVelocities(part.of(group), biasRate_, v, unused); });
}

void JointTrees::projectVelocities(int group, std::span<Velocity> v) {
    if (empty()) return;
    Correction unused;
    forests_[0].each([&](auto& part) {
        for (const int tree : part.of(group))
            if (part.isWhole(tree)) part.solveVelocities(std::span(&tree, 1), 0.0, v, unused);
    });
}

void JointTrees::keepStart(int group, std::span<const Velocity> v) {
    for (Forest& forest : forests_)
        forest.each([&](auto& part) { part.keepStart(part.of(group), v); });
}

void JointTrees::keepEnd(int group, std::span<const Pose> poses) {
    for (Forest& forest : forests_)
        forest.each([&](auto& part) { part.keepEnd(part.of(group), poses); });
}

void JointTrees::nudge(int group, const TreeNudge& nudge, std::span<const Joint> joints, Bodies& bodies) {
    for (Forest& forest : forests_)
        forest.each([&](auto& part) { part.nudge(part.of(group), nudge, joints, bodies); });
}

void JointTrees::beginStep() {
    for (Forest& forest : forests_)
        forest.each([](auto& part) {
            for (auto& joint : part.joints()) joint.impulse.setZero(), joint.torque.setZero();
        });
}

void JointTrees::report(std::span<Joint> joints, double dt) const {
    for (const Forest& forest : forests_)
        forest.each([&](const auto& part) {
            for (const auto& joint : part.joints())
                engine::report(joint, dt, joints[joint.joint]);
        });
}

}  // namespace engine
