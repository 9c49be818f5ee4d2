/// Joints that form trees, solved exactly: one linear system for a whole tree.
///   A lambda = -(J v + b),   A = J M^-1 J^T
/// A chain costs time linear in its links and a tree hardly more. Sweeping a chain of a heavy ball on
/// light links needs thousands of sweeps instead (Catto, GDC 2014: they grow with the ratio of the
/// masses).
///
/// Loops are cut into several forests (joint_forests.h), which are solved one after the other: a
/// sweep over lines instead of points. A row that follows from the others (the three directions that
/// a row of parallel hinges holds twice) shows as a pivot that vanishes; its impulse is 0, so that
/// contradicting joints do not tear at each other with ever larger impulses.
#pragma once
#include "engine/solver/tree_part.h"

namespace engine {

class JointTrees {
public:
    /// Chooses the forests and the order of elimination; sets `inTree`. For when joints come or go.
    void build(std::span<JointConstraint> list, std::span<const Joint> joints,
               std::span<const InverseMass> masses);
    bool empty() const { return forests_.empty(); }
    /// One solve meets all joints: there is one forest only.
    bool exact() const { return forests_.size() <= 1; }

    /// J, C and the factors of A at the bodies' present poses.
    void prepare(std::span<const Joint> joints, const Bodies& bodies);

    /// Before the sweeps of a sub-step. What the first forest got last time makes no difference to
    /// an exact solve; the others start from it. biasRate: Baumgarte's beta / h, 1/s.
    void begin(double keep, double biasRate, std::span<Velocity> v);
    /// J v + b = 0 in one forest after the other: lambda is added up and applied. What an exact solve
    /// had to correct is no residual, however much it was: nothing is left of it.
    void solveVelocities(std::span<Velocity> v, Correction& correction);
    /// J v = 0 once more, for the trees that no other joint pulls at.
    void projectVelocities(std::span<Velocity> v);
    /// After the last sweep: the velocities that the bodies will move by.
    void keepStart(std::span<const Velocity> v);
    /// C = 0 in one forest after the other (joint_nudges.h).
    void nudge(const TreeNudge& nudge, std::span<const Joint> joints, Bodies& bodies);

    void beginStep();                                           // empties the step's books
    /// scale(a, b), of bodies whose sub-steps have got another length.
    template <class Scale>
    void scaleImpulses(const Scale& scale) {
        for (Forest& forest : forests_)
            forest.each([&](auto& part) {
                for (auto& joint : part.joints()) joint.lambda *= scale(joint.a, joint.b);
            });
    }
    void report(std::span<Joint> joints, double dt) const;      // impulses and forces

    /// All joints in trees, by their place in the constraint list, in order of elimination; and those
    /// of them that no other joint pulls at.
    const std::vector<int>& order() const { return order_; }
    const std::vector<int>& whole() const { return whole_; }

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
    std::vector<int> order_, whole_;
    double biasRate_ = 0.0;
};

}  // namespace engine
