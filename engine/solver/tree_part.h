/// The trees of a forest whose joints have at most N rows, solved exactly:
///   A lambda = -(J v + b),   A = J M^-1 J^T
/// A has a block for every joint and one for every two joints that share a movable body
/// (tree_joint.h); block_factors.h solves it.
#pragma once
#include "engine/constraints/contact_constraint.h"
#include "engine/settings.h"
#include "engine/solver/block_factors.h"
#include "engine/solver/joint_forests.h"
#include "engine/solver/tree_joint.h"

namespace engine {

/// One nudge of joints by impulses on positions (solver/joint_nudges.h).
struct TreeNudge {
    double most = 0.0;  // m: what one nudge may move
    double h = 0.0;     // s, of the sub-step whose velocities it feeds back to; 0: to none
    Gyroscope gyroscope = Gyroscope::momentum;
    bool pushed = false;  // contacts have moved bodies since the nudge before
};

template <int N>
class TreePart {
public:
    /// The trees of the plan that have more than `fewest` rows a joint, and at most N.
    void build(const ForestPlan& plan, int fewest, std::span<const JointConstraint> list,
               std::span<const Joint> joints);

    /// J and C at the bodies' poses.
    void place(std::span<const Joint> joints, std::span<const Pose> poses);
    /// The factors of A, for J as it is; `masses` are those of the same poses.
    void factor(std::span<const InverseMass> masses);

    /// Applies `keep` of the impulses of the last step; 0 only forgets them.
    void warmStart(double keep, std::span<Velocity> v);
    /// Afterwards J v + biasRate C = 0; of `wholeOnly` trees.
    void solveVelocities(double biasRate, bool wholeOnly, std::span<Velocity> v,
                         Correction& correction);
    /// The velocities that the bodies are about to move by, from the poses of place().
    void keepStart(std::span<const Velocity> v);
    /// Afterwards C = 0 to first order, and v as a whole tree's feedback wants it: there C = 0 is met to
    /// round-off, by moving once more from the start with another velocity.
    void nudge(const TreeNudge& nudge, std::span<const Joint> joints, Bodies& bodies);

    bool empty() const { return joints_.empty(); }
    std::vector<TreeJoint<N>>& joints() { return joints_; }
    const std::vector<TreeJoint<N>>& joints() const { return joints_; }
    bool isWhole(const TreeJoint<N>& joint) const { return trees_[joint.tree].whole; }

private:
    struct Tree {
        bool whole = true;   // solved exactly as it stands
        double worst = 0.0;     // largest |C|, m or rad
        double ratio = 0.0;     // largest |C| / lever arm
        double sum = 0.0;       // of the largest |C| of its joints
        double before = 0.0;    // the same at the nudge before; below 0: this is the first
        bool closed = false;    // held twice
        double gain = 0.0;      // 1/s
        bool anew = false;      // it moves once more from the start
        bool again = false;     // Newton's method goes on
        double farthest = 0.0;  // m, of what its nudge would move
        double share = 1.0;     // of that, what it does move
    };
    struct Member {
        int body = -1;
        int tree = -1;
        Quat start = Quat::Identity();  // of the sub-step, and where the spin takes it from there
        Quat end = Quat::Identity();
        Velocity kept = {};             // at the start, before any feedback
        Vec3 spin = Vec3::Zero();       // at the start, with it
    };

    int own(int body, int tree, std::vector<int>& places);
    void evaluateErrors(std::span<const Joint> joints, std::span<const Pose> poses);
    /// A chain drawn straight between two posts has next to no way to give its errors a direction: the
    /// linear solution goes round the world for them. It is cut to where it can be meant.
    void limitMoves();
    /// The nudge before this one, with the same J, has made such a tree's errors no smaller.
    static bool isInVain(const Tree& tree) {
        return tree.closed && tree.before >= 0.0 && tree.sum >= tree.before;
    }
    void chooseGains(const TreeNudge& nudge, const Bodies& bodies);
    /// One Newton step of all trees, or of those alone that it brings nearer.
    void nudgeOnce(const TreeNudge& nudge, bool more, Bodies& bodies);
    /// The feedback of trees that Newton's steps do not meet is taken back: their errors are no small
    /// ones, or the sub-step is too long for their tension.
    void takeBackFeedback(const TreeNudge& nudge, Bodies& bodies);
    bool isMet() const;
    void move(const TreeNudge& nudge, Bodies& bodies);
    void moveAnew(Member& member, const Vec3& turn, const TreeNudge& nudge, Bodies& bodies) const;

    std::vector<TreeJoint<N>> joints_;  // in order of elimination
    BlockFactors<N> factors_;
    std::vector<Tree> trees_;
    std::vector<Member> members_;
    std::vector<InverseMass> masses_;  // of the members
    std::vector<Velocity> moved_;      // of the members, by the nudge: m, rad
    std::vector<TreeRows<N>> x_, fed_;  // fed_: what was booked of the nudges of this sub-step
    bool anyWhole_ = false;
};

extern template class TreePart<3>;
extern template class TreePart<5>;
extern template class TreePart<6>;

}  // namespace engine
