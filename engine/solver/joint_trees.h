/// Joints that form trees, solved exactly: one linear system for a whole tree.
///   A lambda = -(J v + b),   A = J M^-1 J^T
/// A chain costs time linear in its links and a tree hardly more. A heavy ball on a chain of light links
/// needs thousands of sweeps instead (Catto, GDC 2014: they grow with the mass ratio).
///
/// Rings and trusses are solved as one tree; many loops are cut into several forests (joint_forests.h),
/// which are solved one after the other: a sweep over lines instead of points. A row that depends on the
/// others (the three directions that a row of parallel hinges holds twice) has a vanishing pivot; its impulse
/// is 0, so contradicting joints do not build up ever larger impulses against each other.
#pragma once
#include "engine/solver/tree_part.h"

namespace engine {

class JointTrees {
public:
    /// Chooses the forests and the order of elimination; sets `inTree`. Called when joints are added or
    /// removed. All trees are in group 0 then.
    void build(std::span<JointConstraint> list, std::span<const Joint> joints,
               std::span<const InverseMass> masses);
    bool empty() const { return forests_.empty(); }
    /// Sorts the trees into groups that are solved on their own; `groupOf(a, b)`: that of a joint's bodies.
    template <class GroupOf>
    void sortInto(int groups, const GroupOf& groupOf) {
        exactGroups_.assign(groups, 1);
        for (std::size_t i = 0; i < forests_.size(); ++i)
            forests_[i].each([&](auto& part) {
                part.sortInto(groups, groupOf);
                for (int g = 0; g < groups; ++g)
                    exactGroups_[g] = exactGroups_[g] && (i == 0 || part.of(g).empty()) && part.isExact(part.of(g));
            });
    }
    /// One solve satisfies all joints of the group's trees: they are in one forest, and none is torn.
    bool isExact(int group) const { return exactGroups_[group] != 0; }

    /// Computes J, C and the factors of A at the present poses.
    void prepare(int group, std::span<const Joint> joints, const Bodies& bodies);

    /// Called before the sweeps of a sub-step. What is solved exactly does not need its previous impulses; nets
    /// start from theirs.
    void begin(int group, double keep, std::span<Velocity> v);
    /// Of the next solves: Baumgarte's beta / h, 1/s.
    void setBiasRate(double rate) { biasRate_ = rate; }
    double biasRate() const { return biasRate_; }
    /// Solves J v + b = 0 in one forest after the other, accumulating and applying lambda. The corrections of an
    /// exact solve do not count as residual, because no error is left.
    void solveVelocities(int group, std::span<Velocity> v, Correction& correction);
    /// Trees by number, for tree_drives.h.
    int treeCount() const { return forests_.empty() ? 0 : forests_[0].balls.treeCount(); }
    /// The tree of a joint of the world, if it is solved exactly by itself; or -1.
    int exactTreeOf(int joint) const;
    int jointsOf(int tree) const;
    template <class What>
    void eachBody(int tree, const What& what) const {
        forests_[0].each([&](const auto& part) { part.eachBody(tree, what); });
    }
    /// The changes v of velocities by some impulse become those after the tree is solved again. Appends its impulses,
    /// of which bookResponse() adds a share to the totals.
    void respond(int tree, std::span<Velocity> v, std::vector<double>& impulses);
    void bookResponse(int tree, std::span<const double> impulses, double share);
    void solveTree(int tree, std::span<Velocity> v);
    /// Whether joints of a group are in several forests; the forests before the last once more, in the opposite
    /// order: a sweep there and back is symmetric, as conjugate gradients need it.
    bool isNet(int group) const;
    void solveBack(int group, std::span<Velocity> v);
    /// Solves J v = 0 once more, for the trees that no other joint acts on.
    void projectVelocities(int group, std::span<Velocity> v);
    /// After the last sweep: stores the velocities with which the bodies will move.
    void keepStart(int group, std::span<const Velocity> v);
    /// Before the first nudge: stores the rotations to which these have led.
    void keepEnd(int group, std::span<const Pose> poses);
    /// Solves C = 0 in one forest after the other (joint_nudges.h).
    void nudge(int group, const TreeNudge& nudge, std::span<const Joint> joints, Bodies& bodies);

    void beginStep();                                           // resets the step's totals
    /// Scales the impulses by scale(a, b), for bodies whose sub-step length has changed.
    template <class Scale>
    void scaleImpulses(const Scale& scale) {
        for (Forest& forest : forests_)
            forest.each([&](auto& part) {
                for (auto& joint : part.joints()) joint.lambda *= scale(joint.a, joint.b);
            });
    }
    void report(std::span<Joint> joints, double dt) const;      // impulses and forces

    /// What is kept of trees, once they are built, in a state (base/state_bytes.h). `masses`: of the bodies,
    /// at the poses for which the trees were prepared last.
    template <class Bytes>
    void keep(Bytes& bytes, std::span<const InverseMass> masses) {
        for (Forest& forest : forests_)
            forest.each([&](auto& part) {
                part.keep(bytes);
                if constexpr (Bytes::kReads)
                    if (bytes.isGood()) part.factor(part.all(), masses);
            });
    }

    /// Calls visit(joint, mass of a, mass of b) for every joint of a group's trees, always in the same order.
    template <class Visit>
    void eachJoint(int group, const Visit& visit) {
        for (Forest& forest : forests_)
            forest.each([&](auto& part) { part.eachJoint(part.of(group), visit); });
    }

    /// All joints in trees, by index in the constraint list, in order of elimination; those in trees that no
    /// other joint acts on; the others; and of the former those in trees with loops, or held twice.
    const std::vector<int>& order() const { return order_; }
    const std::vector<int>& whole() const { return whole_; }
    const std::vector<int>& inNets() const { return inNets_; }
    const std::vector<int>& inLoops() const { return inLoops_; }

private:
    struct Forest {
        TreePart<3> balls;  // and rods
        TreePart<5> hinges;
        TreePart<6> welds;

        template <class Do>
        void each(Do what) {
            what(balls), what(hinges), what(welds);
        }
        template <class Do>
        void each(Do what) const {
            what(balls), what(hinges), what(welds);
        }
    };

    std::vector<Forest> forests_;
    std::vector<int> order_, whole_, inNets_, inLoops_;
    std::vector<int> exactTrees_;  // by joint of the world
    std::vector<char> exactGroups_{1};
    double biasRate_ = 0.0;
};

}  // namespace engine
