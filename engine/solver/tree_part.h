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
    double most = 0.0;  // m: limit of one nudge
    double h = 0.0;     // s, of the sub-step whose velocities get feedback; 0: no feedback
    Gyroscope gyroscope = Gyroscope::momentum;
    bool pushed = false;  // contacts have moved bodies since the last nudge
};

template <int N>
class TreePart {
public:
    /// Builds the trees of the plan with more than `fewest` and at most N rows per joint.
    void build(const ForestPlan& plan, int fewest, std::span<const JointConstraint> list,
               std::span<const Joint> joints);

    /// Computes J and C at the bodies' poses.
    void place(std::span<const Joint> joints, std::span<const Pose> poses);
    /// Factors A, for the present J; `masses` are at the same poses.
    void factor(std::span<const InverseMass> masses);

    /// Applies the share `keep` of the impulses of the last step; 0 only discards them.
    void warmStart(double keep, std::span<Velocity> v);
    /// Solves J v + biasRate C = 0; if `wholeOnly`, for whole trees only.
    void solveVelocities(double biasRate, bool wholeOnly, std::span<Velocity> v,
                         Correction& correction);
    /// Stores the velocities with which the bodies will move from the poses of place().
    void keepStart(std::span<const Velocity> v);
    /// Solves C = 0 to first order. Whole trees with feedback are solved to round-off, by repeating the
    /// motion from the start with another velocity, which becomes v.
    void nudge(const TreeNudge& nudge, std::span<const Joint> joints, Bodies& bodies);

    bool empty() const { return joints_.empty(); }
    std::vector<TreeJoint<N>>& joints() { return joints_; }
    const std::vector<TreeJoint<N>>& joints() const { return joints_; }
    bool isWhole(const TreeJoint<N>& joint) const { return trees_[joint.tree].whole; }

private:
    struct Tree {
        bool whole = true;   // no other joint acts on it
        double worst = 0.0;     // largest |C|, m or rad
        double ratio = 0.0;     // largest |C| / lever arm
        double sum = 0.0;       // of the largest |C| of each joint
        double before = 0.0;    // the same at the previous nudge; below 0: none
        bool closed = false;    // held twice
        double gain = 0.0;      // 1/s
        bool anew = false;      // it repeats the motion from the start
        bool again = false;     // Newton's method continues
        double farthest = 0.0;  // m, largest displacement by its nudge
        double share = 1.0;     // of the displacement that is applied
    };
    struct Member {
        int body = -1;
        int tree = -1;
        Quat start = Quat::Identity();  // of the sub-step, and its end with the spin
        Quat end = Quat::Identity();
        Velocity kept = {};             // at the start, before any feedback
        Vec3 spin = Vec3::Zero();       // at the start, with feedback
    };

    int own(int body, int tree, std::vector<int>& places);
    void evaluateErrors(std::span<const Joint> joints, std::span<const Pose> poses);
    /// A chain pulled straight between two posts can hardly correct errors along it: the linear solution for
    /// them is huge. It is limited to a plausible size.
    void limitMoves();
    /// The previous nudge, with the same J, did not reduce the errors of a closed tree.
    static bool isInVain(const Tree& tree) {
        return tree.closed && tree.before >= 0.0 && tree.sum >= tree.before;
    }
    void chooseGains(const TreeNudge& nudge, const Bodies& bodies);
    /// One Newton step of all trees, or if `more`, only of those where it still helps.
    void nudgeOnce(const TreeNudge& nudge, bool more, Bodies& bodies);
    /// Undoes the feedback of trees where Newton's method does not converge: their errors are too large, or
    /// the sub-step is too long for their tension.
    void takeBackFeedback(const TreeNudge& nudge, Bodies& bodies);
    bool isMet() const;
    void move(const TreeNudge& nudge, Bodies& bodies);
    void moveAnew(Member& member, const Vec3& turn, const TreeNudge& nudge, Bodies& bodies) const;

    std::vector<TreeJoint<N>> joints_;  // in order of elimination
    BlockFactors<N> factors_;
    std::vector<Tree> trees_;
    std::vector<Member> members_;
    std::vector<InverseMass> masses_;  // by member
    std::vector<Velocity> moved_;      // by member: motion in this nudge, m, rad
    std::vector<TreeRows<N>> x_, fed_;  // fed_: impulses added by the nudges of this sub-step
    bool anyWhole_ = false;
};

extern template class TreePart<3>;
extern template class TreePart<5>;
extern template class TreePart<6>;

}  // namespace engine
