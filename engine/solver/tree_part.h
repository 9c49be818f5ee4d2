/// The trees of a forest whose joints have at most N rows, solved exactly:
///   A lambda = -(J v + b),   A = J M^-1 J^T
/// A has a block for every joint and one for every two joints that share a movable body
/// (tree_joint.h); block_factors.h solves it.
///
/// A tree with loops that do not fit is damped: A + mu diag(A) instead of A. As A + mu diag(A) >= A, no solve
/// adds energy, however nearly dependent rows are; several solves come as close as needed to J v = 0. It has no
/// feedback of nudges into velocities, which would be the velocity of a motion that is impossible.
/// In a net, every tree that closes loops or is held twice is damped: a flat net that is held all around cannot
/// move, and its trees would push each other away. All rows of a net are soft, with a small gamma:
///   (A + gamma) lambda' = -(J v + b + gamma lambda)
/// which keeps impulses small where the bodies can hardly move; it only takes energy, as every softness.
#pragma once
#include "engine/constraints/contact_constraint.h"
#include "engine/settings.h"
#include "engine/solver/block_factors.h"
#include "engine/base/by_group.h"
#include "engine/solver/joint_forests.h"
#include "engine/solver/tree_joint.h"

namespace engine {

/// One nudge of joints by impulses on positions (solver/joint_nudges.h).
struct TreeNudge {
    double most = 0.0;  // m: limit of one nudge
    Gyroscope gyroscope = Gyroscope::momentum;
    bool feeds = false;   // velocities get feedback
    bool pushed = false;  // contacts or limits have moved bodies since the last nudge
};

template <int N>
class TreePart {
public:
    /// Builds the trees of the plan with more than `fewest` and at most N rows per joint.
    void build(const ForestPlan& plan, int fewest, std::span<const JointConstraint> list,
               std::span<const Joint> joints);

    // Of the trees with these numbers:

    /// Computes J and C at the bodies' poses.
    void place(std::span<const int> trees, std::span<const Joint> joints, std::span<const Pose> poses);
    /// Computes kappa of trees without RATTLE, because other joints act on their bodies; but not of nets, which whip
    /// more with it, and need more sub-steps then.
    void bend(std::span<const int> trees, std::span<const Joint> joints, const Bodies& bodies);
    /// Factors A, for the present J; `masses` are at the same poses.
    void factor(std::span<const int> trees, std::span<const InverseMass> masses);
    /// Applies the share `keep` of the impulses of the last sub-step; 0, and trees outside nets, only discard them.
    void warmStart(std::span<const int> trees, double keep, std::span<Velocity> v);
    /// Solves J v + kappa + biasRate C + gamma lambda = 0 in these trees; gamma: 0 but in nets.
    void solveVelocities(std::span<const int> trees, double biasRate, std::span<Velocity> v,
                         Correction& correction);
    /// Adds to the changes v of velocities by some impulse those by which a tree responds, and appends its impulses.
    void respond(int tree, std::span<Velocity> v, std::vector<double>& impulses);
    /// Adds a share of such impulses to the totals.
    void bookResponse(int tree, std::span<const double> impulses, double share);
    /// Stores the velocities with which the bodies will move from the poses of place(), and, after they have
    /// moved, the rotations to which these lead: whole trees start from them when they move again.
    void keepStart(std::span<const int> trees, std::span<const Velocity> v);
    void keepEnd(std::span<const int> trees, std::span<const Pose> poses);
    /// Solves C = 0 to first order. Whole trees with feedback are solved to round-off, by repeating the
    /// motion from the start with another velocity, which becomes v.
    void nudge(std::span<const int> trees, const TreeNudge& nudge, std::span<const Joint> joints, Bodies& bodies);

    /// Numbers of the trees with joints here: all, and those of a group.
    std::span<const int> all() const { return here_; }
    std::span<const int> of(int group) const { return byGroup_.of(group); }
    /// No other joint acts on it.
    bool isWhole(int tree) const { return trees_[tree].whole; }
    int treeCount() const { return static_cast<int>(trees_.size()); }
    /// Of a tree, or 0 if they are in another part.
    int jointsOf(int tree) const { return trees_[tree].end - trees_[tree].first; }
    /// One solve satisfies the tree, and no other rigid joint acts on it.
    bool isExact(int tree) const { return trees_[tree].whole && !trees_[tree].damped && !trees_[tree].inNet; }
    template <class What>
    void eachBody(int tree, const What& what) const {
        for (int i = trees_[tree].firstMember; i < trees_[tree].endMember; ++i) what(members_[i].body);
    }
    /// Sorts the trees into groups by their bodies; -1: into none.
    template <class GroupOf>
    void sortInto(int groups, const GroupOf& groupOf) {
        byGroup_.sort(static_cast<int>(trees_.size()), groups, [&](int number) {
            const Tree& tree = trees_[number];
            if (tree.end == 0) return -1;  // its joints are in another part
            return groupOf(joints_[tree.first].a, joints_[tree.first].b);
        });
    }

    /// What is kept of a tree in a state (base/state_bytes.h), between two steps: impulses, and the geometry
    /// from which factor() has made the rest.
    template <class Bytes>
    void keep(Bytes& bytes) {
        for (TreeJoint<N>& joint : joints_) {
            TreeGeometry<N>& g = joint.now;
            bytes(joint.lambda, joint.bend, g.armA, g.armB, g.error);
            if (joint.type == JointType::hinge) bytes(g.along);
            for (int i = 0; i < joint.pointRows && joint.pointRows < 3; ++i) bytes(g.point[i]);
            if constexpr (N > 3) bytes(g.twist);
            if constexpr (N > 3)
                if (joint.isGear) bytes(joint.twistOfA);
        }
        for (Member& member : members_) bytes(member.start);
        if constexpr (Bytes::kReads)
            for (Tree& tree : trees_) tree.before = -1.0;
    }

    /// One solve satisfies these trees.
    bool isExact(std::span<const int> trees) const {
        for (const int number : trees)
            if (trees_[number].damped) return false;
        return true;
    }
    /// Calls visit(joint, mass of a, mass of b) for every joint of these trees, always in the same order.
    template <class Visit>
    void eachJoint(std::span<const int> trees, const Visit& visit) {
        for (const int number : trees)
            for (int k = trees_[number].first; k < trees_[number].end; ++k)
                visit(joints_[k], masses_[joints_[k].ownA], masses_[joints_[k].ownB]);
    }
    std::vector<TreeJoint<N>>& joints() { return joints_; }
    const std::vector<TreeJoint<N>>& joints() const { return joints_; }

private:
    struct Tree {
        bool whole = true;   // no other joint acts on it
        int first = 0, end = 0;  // of its joints
        int firstMember = 0, endMember = 0;
        double worst = 0.0;     // largest |C|, m or rad
        double ratio = 0.0;     // largest |C| / lever arm
        double sum = 0.0;       // of the largest |C| of each joint
        double before = 0.0;    // the same at the previous nudge; below 0: none
        bool closed = false;    // held twice, or with a loop of other joints than gears
        bool geared = false;
        bool damped = false;    // closed and torn
        bool inNet = false;     // joints of its connected set are in several forests
        bool yields() const { return damped || (closed && !whole); }
        int closings = 0;       // joints that close it
        double h = 0.0;         // s, of its sub-step
        double gain = 0.0;      // 1/s
        bool anew = false;      // it repeats the motion from the start
    };
    struct Member {
        int body = -1;
        Quat start = Quat::Identity();  // of the sub-step, and its end with the spin
        Quat end = Quat::Identity();
        Quat before = Quat::Identity(); // the end before this nudge
        Velocity kept = {};             // at the start, before any feedback
        Vec3 spin = Vec3::Zero();       // at the start, with feedback
    };
    /// By member: a sub-step that is repeated by implicit Euler (tree_implicit.h).
    struct Repeat {
        Pose led, nudged;                // where its velocity led, and nudges did
        Pose target;                     // q*
        Velocity free;                   // v*
        double inertia = 1.0, mass = 1.0;  // (M + G) / M
    };

    std::span<TreeJoint<N>> jointsIn(int tree) {
        return std::span(joints_).subspan(trees_[tree].first, trees_[tree].end - trees_[tree].first);
    }
    std::span<Member> membersIn(int tree) {
        return std::span(members_).subspan(trees_[tree].firstMember, trees_[tree].endMember - trees_[tree].firstMember);
    }

    int own(int body, std::vector<int>& places);
    /// Sets the blocks of A in the column of joint k.
    void setBlocks(int k);
    /// The coupling of joint k with i through a common body.
    TreeBlock<N> coupling(const TreeJoint<N>& i, const TreeJoint<N>& k, int body) const;
    void evaluateErrors(Tree& tree, std::span<const Joint> joints, std::span<const Pose> poses);
    /// A chain pulled straight between two posts can hardly correct errors along it: the linear solution for
    /// them is huge. So it may be in any tree whose joints are far apart. It is limited to a plausible size
    /// for the sum of the errors.
    void limitMoves(Tree& tree, double sum);
    /// The previous nudge, with the same J, did not reduce the errors of a closed tree.
    static bool isInVain(const Tree& tree) {
        return tree.closed && tree.before >= 0.0 && tree.sum >= tree.before;
    }
    void chooseGain(Tree& tree, const TreeNudge& nudge, const Bodies& bodies) const;
    /// One Newton step.
    void nudgeOnce(Tree& tree, const TreeNudge& nudge, Bodies& bodies);
    void nudgeUntilMet(Tree& tree, const TreeNudge& nudge, std::span<const Joint> joints, Bodies& bodies);
    /// Whether another step helps. Undoes the feedback of a tree where Newton's method does not converge: its
    /// errors are too large, or the sub-step is too long for its tension.
    bool goesOn(Tree& tree, const TreeNudge& nudge, Bodies& bodies);
    void takeBackFeedback(Tree& tree, const TreeNudge& nudge, Bodies& bodies);
    /// Whether the sub-step of a tree may be repeated by implicit Euler if Newton's method fails: it began with joints
    /// that were closed, and nothing else has moved the bodies. `poses`, which must be kept before: where v leads.
    bool mayRepeat(const Tree& tree, const TreeNudge& nudge) const;
    void keepLed(const Tree& tree, std::span<const Pose> poses);
    /// Repeats it, or leaves the bodies as they are if that fails, too.
    void repeat(Tree& tree, const TreeNudge& nudge, std::span<const Joint> joints, Bodies& bodies);
    void findTargets(const Tree& tree, Bodies& bodies);
    void stiffen(const Tree& tree, const Bodies& bodies);
    void solveStep(const Tree& tree, const Bodies& bodies);
    bool takeStep(const Tree& tree, Bodies& bodies);
    void setVelocities(const Tree& tree, Bodies& bodies);
    double lookAnew(const Tree& tree, std::span<const Joint> joints, std::span<const Pose> poses);
    void move(const Tree& tree, const TreeNudge& nudge, Bodies& bodies);
    /// Turns the bodies of a tree that moves anew as their ends have turned; contacts may have nudged them
    /// too.
    void turnToEnd(const Tree& tree, Bodies& bodies) const;

    std::vector<TreeJoint<N>> joints_;  // one tree after the other, each in order of elimination
    BlockFactors<N> factors_;
    std::vector<Tree> trees_;
    std::vector<int> here_;             // trees with joints here
    ByGroup byGroup_;
    std::vector<Member> members_;
    std::vector<InverseMass> masses_;  // by member
    std::vector<Repeat> repeats_;      // by member
    std::vector<Velocity> moved_;      // by member: motion in this nudge, m, rad
    std::vector<TreeRows<N>> x_, fed_;  // fed_: impulses added by the nudges of this sub-step
};

extern template class TreePart<3>;
extern template class TreePart<5>;
extern template class TreePart<6>;

}  // namespace engine
